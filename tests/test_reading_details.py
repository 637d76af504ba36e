"""Details of ordinary prompts: sides and ends, what is of each and what of all, kinds told later, numbered items."""

import pytest

from tests.test_reading_turns import counted, related
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        # What is of each of several, and what is of all of them or of the room.
        ("Three pallets, each stacked with four boxes, and a forklift parked next to them.",
         ["1 forklift next_to pallet"]),
        ("Six tables, each covered with a cloth and set with two plates and a candle.",
         ["12 plate on dining_table", "6 candle on dining_table"]),
        ("A room that seats twelve around a table, with a projector hanging from the ceiling.",
         ["1 ceiling_projector on ceiling"]),
        ("A sunroom full of plants, with two armchairs and a table between them.", ["1 coffee_table between armchair"]),
        ("Three workbenches, a clock on the first two.", ["2 clock on workbench"]),
        # What a room has that is named after things in it, and what two face each other across.
        ("A picnic table with a basket on it, in a conservatory with a fern.", ["1 basket on picnic_table"]),
        ("Two sofas facing each other across a coffee table.",
         ["2 sofa facing sofa", "1 coffee_table between sofa"]),
        ("Two armchairs face each other over a small table.", ["1 coffee_table between armchair"]),
        ("A sofa and an armchair facing each other across a low table.", ["1 coffee_table between sofa armchair"]),
        ("Two parallel rows of three workbenches, each with a vise.", ["6 workbench in_rows", "6 vise on workbench"]),
        ("A long row of six lockers.", ["6 locker in_rows"]),
        ("Four beds, two along each side wall.", ["4 bed against_wall wall"]),
        # Where all of a list are that is told only of its last thing, or before the first.
        ("A kids' room with a loft bed, a desk and a chair below it.",
         ["1 desk under bunk_bed", "1 chair under bunk_bed"]),
        ("A loft bed with a desk, a chair and a bookcase underneath.",
         ["1 desk under bunk_bed", "1 chair under bunk_bed", "1 bookcase under bunk_bed"]),
        ("A table, two chairs at its long side, a chair at its short side. None of the chairs may be next to the door.",
         ["2 chair next_to door", "1 chair-2 next_to door"]),
        # Where contents are said to be, what holds them is.
        ("A toolbox with a hammer and a wrench in it on a workbench.",
         ["1 wrench inside toolbox", "1 hammer inside toolbox", "1 toolbox on workbench"]),
        ("A tray with two cups on it on the coffee table.", ["2 cup on tray", "1 tray on coffee_table"]),
        # A low seat is under a desk; chairs, and several seats under one table, are at it.
        ("A desk with a stool tucked under it.", ["1 stool under desk"]),
        ("Two desks, each with a stool under it.", ["2 stool under desk"]),
        ("A desk with a chair under it.", ["1 chair at desk"]),
        ("A table with four stools tucked under it.", ["4 stool around dining_table"]),
        ("A desk and a dresser under the loft bed.", ["1 desk under bunk_bed", "1 dresser under bunk_bed"]),
        ("A TV, a sofa and an armchair facing it.", ["1 sofa facing tv", "1 armchair facing tv"]),
        ("A bed. At its foot are a bench and a trunk.", ["1 bench at_foot_of bed", "1 chest at_foot_of bed"]),
        ("A console. Under it are two baskets and an umbrella stand.",
         ["2 basket under console_table", "1 umbrella_stand under console_table"]),
        ("A kitchen with a fridge, a stove and a sink, and wall cabinets above them.",
         ["2 wall_cabinet above fridge stove sink"]),
        ("A curtain in the middle. Each side has a bed.", ["1 bed left_of curtain", "1 bed-2 right_of curtain"]),
        # Of each of several, and of all that were told apart.
        ("Three beds, each with two pillows on it, a shelf on the wall above it and a box under it.",
         ["3 wall_shelf above bed", "3 box under bed"]),
        ("Two tables, each with a bench on both long sides and a lantern hanging from the ceiling above it.",
         ["2 lantern above dining_table", "4 bench at_long_side dining_table"]),
        ("Three benches; on each of them five books and a tray, above each a lamp.",
         ["15 book on bench", "3 tray on bench", "3 pendant_lamp above bench"]),
        ("Nine stools in front of a counter, and for every stool a bowl, a spoon and a napkin on the counter.",
         ["9 bowl on counter", "9 spoon on counter", "9 napkin on counter"]),
        ("A table, four chairs along each long side and one at either end. Per seat a plate with a napkin on it.",
         ["10 plate on dining_table", "10 napkin on plate"]),
        ("Five tables; each table has one little flag in the middle.", ["5 flag in_centre dining_table"]),
        ("Three stools, one blue and two green, stand at the counter.",
         ["1 bar_stool at counter", "2 bar_stool-2 at counter"]),
        ("A red and two blue chairs at the table.", ["1 chair around dining_table", "2 chair-2 around dining_table"]),
        ("Two lab benches. On the one in the middle: six beakers. On the one by the wall: a scale with a bin under it.",
         ["1 lab_bench in_centre centre", "6 beaker on lab_bench", "1 scale on lab_bench-2",
          "1 lab_bench-2 against_wall wall", "1 waste_bin under lab_bench-2"]),
        ("Two tables. The one by the window has a vase, the one in the corner a lamp.",
         ["1 vase on dining_table", "1 table_lamp on dining_table-2"]),
        ("Framed art all over the walls and a tattoo chair.", ["8 picture on wall"]),
        # What is told again, or with a pronoun, of what the sentence named.
        ("There is the stove, a black one, against the wall. To its left is a basket.",
         ["1 stove against_wall wall", "1 basket left_of stove"]),
        ("Under the bed lies a jute rug and on that, three magazines.", ["3 magazine on rug"]),
        ("A piano; it has a skull and a metronome on top, the metronome to the left of the skull.",
         ["1 metronome left_of skull", "1 metronome on piano", "1 skull on piano"]),
        ("A media console with two game consoles on it, the TV on the wall above the console.",
         ["1 wall_tv above tv_stand"]),
        ("A trunk does duty as a nightstand, with a lamp and a carafe on it.", ["1 carafe on chest"]),
        ("The crib is round; my wife insisted. It goes in the corner.", ["1 crib in_corner corner"]),
        ("The dock stands within a metre and a half of the door.", ["1 dock near door"]),
        ("A lamp within 50 cm of the bed.", ["1 floor_lamp next_to bed"]),
        ("Wall bars are mounted on the wall.", ["1 wall_bars on wall"]),
        # What "its" and "the other" are, and what is told past a wall.
        ("A chair, a stool on its left and a cart with instruments on its right.",
         ["1 stool left_of chair", "1 serving_trolley right_of chair"]),
        ("A desk with four monitors on the wall above it and a locker.", ["4 monitor above desk", "4 monitor on wall"]),
        ("A desk, two chairs facing each other across it.", ["1 desk between chair"]),
        ("A clock and two candles on the shelf.", ["1 clock on shelving_unit", "2 candle on shelving_unit"]),
        ("Three bunk beds, one against each of three walls.", ["3 bunk_bed against_wall wall"]),
        ("A gym with a rack with eight dumbbells.", ["8 dumbbell on dumbbell_rack"]),
        ("Three wheels, each with a stool and a bucket.", ["3 bucket next_to wheel"]),
        # What is not of each though the sentence tells of each, and what surrounds a thing.
        ("Two tables, each with a teapot, and scrolls on two of the walls.", ["2 scroll on wall"]),
        ("Four hooks, each with a coat and a bag, and a shoe rack under the hooks.", ["1 shoe_rack under coat_hooks"]),
        ("Five mirrors, each framed by bulbs with a chair in front.", ["5 chair in_front_of mirror"]),
        ("A sofa flanked by two lamps, with a rug in front.", ["1 rug in_front_of sofa"]),
        ("The bed faces the window; a bench with a blanket at its foot.",
         ["1 bench at_foot_of bed", "1 blanket on bench"]),
        ("Two hospital beds, each with a monitor.", ["2 monitor next_to hospital_bed"]),
        ("A table in the middle, a trolley with jars at its head.", ["1 serving_trolley at_short_side dining_table"]),
        ("Mats for eight people in two rows.", ["8 door_mat in_rows"]),
        # What there is one of for each, and what lies on what was named before.
        ("A round table, three microphones on it, one per chair, headphones hanging from each chair.",
         ["3 microphone on dining_table", "3 headphones on chair"]),
        ("Four chairs around a table, one plate per chair.", ["4 plate on dining_table"]),
        ("Six chairs, one book per chair.", ["6 book on chair"]),
        ("A crib, a changing table; on the changing table diapers and a lotion bottle.",
         ["3 diaper on changing_table", "1 lotion_bottle on changing_table"]),
        ("A desk, a sofa in front, and a table with two plants between the sofa and the desk.",
         ["1 coffee_table between sofa desk", "2 potted_plant on coffee_table"]),
        ("Fifteen desks, one chair each, all facing the front.",
         ["15 desk facing near_wall", "15 chair facing near_wall", "15 chair at desk"]),
        # What containers hold, and what stands below what hangs on a wall.
        ("A desk with a mug of pens and a laptop.", ["1 pens inside cup", "1 laptop on desk"]),
        ("Buckets of roses, tulips and lilies.",
         ["5 cut_flower inside flower_bucket", "5 cut_flower-2 inside flower_bucket"]),
        ("Violins on the wall and a shelf with sheet music under the violins.",
         ["1 shelving_unit under violin", "1 sheet_music inside shelving_unit"]),
        ("A clock on the wall and a table with four chairs under the clock.",
         ["1 dining_table under clock", "4 chair around dining_table"]),
        ("A shoe rack with shoes on the shelves.", ["2 shoes inside shoe_rack"]),
        ("A rack for coats and shoes on the shelf.", ["3 shoes on shelving_unit-2"]),
        ("A cabinet with two doors and a lamp on it.", ["1 table_lamp on cabinet"]),
        # Sides and ends.
        ("Four tables, each with a lamp and six chairs, three on each side.", ["24 chair at_long_side dining_table"]),
        ("A desk is at the front left.", ["1 desk in_corner near_wall left_wall"]),
        ("A bed, its headboard touching the east wall.", ["1 bed against_wall east_wall"]),
        ("A desk with its back to the wall.", ["1 desk against_wall wall"]),
        # What carries what.
        ("A workbench against the far wall, a pegboard with tools above it, and a bicycle on the left wall.",
         ["1 pegboard above workbench", "1 tools on pegboard", "1 wall_bicycle on left_wall"]),
        ("A counter and open shelves with mugs above the sink.", ["2 wall_shelf above sink"]),
        ("A mug on the kitchen counter, next to the sink.", ["1 cup next_to sink", "1 cup on base_cabinet"]),
        ("A table with a vase with a single flower.", ["1 cut_flower inside vase"]),
        ("A cello on a stand.", ["1 cello on guitar_stand"]),
        ("A fruit bowl with apples on the counter.", ["3 apple inside fruit_bowl", "1 fruit_bowl on counter"]),
        ("A vase with two roses on the table.", ["2 cut_flower inside vase", "1 vase on dining_table"]),
        # Of which kind something is, told later; numbered items.
        ("Six chairs around a table, two of which are armchairs.",
         ["4 chair around dining_table", "2 armchair around dining_table"]),
        ("1. A table. 2. Six chairs around it. 3. A lamp above the table.",
         ["6 chair around dining_table", "1 pendant_lamp above dining_table"]),
        ("A room with eight chairs: four along the walls and four in the middle.",
         ["4 chair against_wall wall", "4 chair-2 in_centre centre"]),
        ("A console with a bowl for keys and a bench with shoes underneath.",
         ["3 key inside bowl", "1 bowl on console_table", "3 shoes under bench"]),
        ("A desk with a mug for pens and a chair.", ["1 chair at desk", "1 cup on desk"]),
        ("A neon sign above the liquor shelf, which holds twelve bottles.", ["12 bottle inside liquor_shelf"]),
        ("Three barrels used as tables, each with two glasses.", ["6 glass on barrel"]),
        ("A bed. On either side stand identical nightstands with lamps.",
         ["1 nightstand left_of bed", "2 table_lamp on nightstand nightstand-2"]),
        ("A vanity with a stool is to the left of the door.",
         ["1 stool at dressing_table", "1 dressing_table left_of door"]),
        ("24 chairs around six tables.", ["24 chair around dining_table"]),
        ("An operating table under two surgical lights.", ["2 surgical_lamp above operating_table"]),
        ("A fridge, a stove and an oven, and wall cabinets above all three.",
         ["2 wall_cabinet above fridge stove oven"]),
        ("Ten stations, each consisting of a desk, two monitors and a chair.", ["10 chair at desk"]),
        ("Four paintings on the left wall, three on the right.",
         ["4 picture on left_wall", "3 picture-2 on right_wall"]),
        ("A fireplace flanked by built-in bookcases.",
         ["1 bookcase left_of fireplace", "1 bookcase-2 right_of fireplace"]),
        ("A table. Six plates, six forks to the left of the plates, and a roast chicken in the centre.",
         ["1 roast_chicken in_centre dining_table"]),
        ("Four microphones on boom arms.", ["4 microphone on boom_arm"]),
        ("A display fridge, wheels of cheese on wooden shelves behind it.",
         ["2 shelving_unit behind display_fridge", "3 wheel_of_cheese on shelving_unit"]),
        ("Two facing benches.", ["2 bench facing bench"]),
        ("A sofa, a loveseat and a recliner around a square coffee table.", ["1 sofa around coffee_table"]),
        ("A monitor with a webcam on a desk.", ["1 monitor on desk", "1 webcam on desk"]),
        ("Two armchairs flank a fireplace. A mirror hangs above the fireplace, and a table stands in front of it.",
         ["1 dining_table in_front_of fireplace"]),
        ("A table with a chessboard and two chairs in the corner.",
         ["2 chair around dining_table", "1 dining_table in_corner corner"]),
        ("A workshop where someone can repair clocks. A bench with a lamp.", ["1 table_lamp on workbench"]),
        # What people do there.
        ("A room where a person can work at a desk. The desk faces the window.", ["1 desk facing window"]),
        ("People can work at a desk and relax on a sofa. The sofa is against the wall, and the desk near the window.",
         ["1 sofa against_wall wall", "1 desk near window"]),
        # Walls.
        ("Fridge, stove and sink along the same wall.",
         ["1 fridge against_wall one_wall", "1 stove against_wall one_wall"]),
        ("A crib next to the window and a changing table on the opposite wall.",
         ["1 changing_table opposite window", "1 changing_table against_wall wall"]),
        ("A bed against the wall and a desk against the opposite wall.",
         ["1 bed against_wall one_wall", "1 desk against_wall opposite_wall"]),
        ("A sofa on the left wall, a TV on the opposite wall.", ["1 wall_tv on right_wall"]),
        ("The north and south walls have bookcases.",
         ["1 bookcase against_wall north_wall", "1 bookcase-2 against_wall south_wall"]),
        ("Shelves on three walls: the left one holds jars, the right one holds cans, and the back one holds boxes.",
         ["1 wall_shelf-2 on right_wall", "3 jar on wall_shelf", "3 box on wall_shelf-3"]),
        ("A dresser on the left wall and a sideboard mounted on the right wall.",
         ["1 dresser against_wall left_wall", "1 sideboard on right_wall"]),
        # What is spoken of again, and what several have or face together.
        ("A TV mounted on the wall across from the sofa, a console table below the TV.",
         ["1 console_table under wall_tv"]),
        ("A fireplace. On each side of the fireplace is an armchair, and a rug lies in front of it.",
         ["1 rug in_front_of fireplace"]),
        ("Six recliners, all facing a projector screen.", ["6 recliner facing projector_screen"]),
        ("A conference hall with a stage and a screen behind it.", ["1 projector_screen behind stage"]),
        ("Three tables, each with a stool beside it and a cabinet.", ["3 cabinet next_to dining_table"]),
        ("A workshop with shelves full of jars and a sink.", ["3 jar inside shelving_unit", "1 sink"]),
        ("Ten desks facing the blackboard and the teacher's desk at the front.", ["1 desk-2 in_front_of blackboard"]),
        ("A lecture hall with thirty chairs, a podium at the front and a screen.", ["1 podium near projector_screen"]),
        ("Nine desks facing the whiteboard, a cabinet against the front wall.", ["1 cabinet against_wall near_wall"]),
        ("36 desks, each with one chair, and a table at the front.", ["1 dining_table against_wall near_wall"]),
        ("A sink with a mirror over it, a toilet beside the sink, and a stack of towels on a stool.",
         ["3 towels on stool"]),
        ("A chapel with an altar with two candlesticks.", ["2 candlestick on altar"]),
        ("A chair, and display racks along the wall.", ["2 shelving_unit against_wall wall"]),
        # What is on tables and shelves "of" it, and what one more of is somewhere else.
        ("A shop with two tables of books and shelves of bread.",
         ["4 book on display_table", "3 bread inside shelving_unit"]),
        ("Three desks, a plant in the corner and one next to the door.",
         ["1 plant in_corner corner", "1 plant-2 next_to door"]),
        # What all have, and how many of several each has.
        ("Four tables and a candle on all tables but one.", ["3 candle on dining_table-2"]),
        ("Five tables, and a jar on every table but the one by the door.",
         ["4 jar on dining_table-2", "1 dining_table next_to door"]),
        ("Four tables. All of them have a candle.", ["4 candle on dining_table"]),
        ("Twelve computers on six desks, two on each desk.", ["12 computer on desk"]),
        ("A lab with three benches and six stools, two at each bench.", ["6 stool at lab_bench"]),
        # What each of several has, to the end of the list, and what that stands by.
        ("A dorm with two loft beds, each with a desk, a chair and a small dresser beneath it.",
         ["2 desk under bunk_bed", "2 chair under bunk_bed", "2 dresser under bunk_bed"]),
        ("Three booths along the window, each with a table between two benches.",
         ["3 dining_table between bench", "6 bench"]),
        ("Four desks, each with a chair next to a plant.", ["4 desk next_to plant", "4 plant"]),
        ("Three tables, each with a vase on a runner.", ["3 vase on rug", "3 rug"]),
        ("A bathroom with three sinks with mirrors.", ["3 mirror above washbasin"]),
        ("A bathroom with five sinks with mirrors along the left wall.", ["5 washbasin against_wall left_wall"]),
        ("Ten tables and benches on both sides of each table.", ["20 bench around dining_table"]),
        ("A bed with a pair of nightstands on each side of it.", ["4 nightstand next_to bed"]),
        ("A desk below a shelf holding five trophies.", ["1 desk under wall_shelf"]),
        # Whose side it is, and which of several are spoken of.
        ("Two massage tables. Each has a stool on its left and a trolley with towels on its right.",
         ["2 serving_trolley right_of massage_table", "4 towels on serving_trolley"]),
        ("A bed. On its left is a nightstand with a phone on it; on its right there is a chair.",
         ["1 nightstand left_of bed", "1 chair right_of bed"]),
        ("Four chairs. Two of them have cushions on them. Between those two is a plant.",
         ["2 pillow on chair", "1 plant between chair"]),
        ("Two shelves, with paint cans on the upper one and a toolbox on the lower one.",
         ["3 paint_can on shelving_unit", "1 toolbox on shelving_unit-2"]),
        ("Three statues. The tallest stands on a pedestal.", ["1 statue on pedestal"]),
        # What lies with others, who are meant by "the chairs", what is all around, and what a screen is.
        ("Two paddles and a ball on the table.", ["2 paddle on dining_table", "1 ball on dining_table"]),
        ("A desk, a chair behind it, two patient chairs in front, and a sign on the wall opposite the chairs.",
         ["1 sign opposite visitor_chair"]),
        ("A fountain in the center and benches on all four sides of the fountain.", ["4 bench around fountain"]),
        ("A bathroom with a toilet behind a screen.", ["1 toilet behind room_divider"]),
        ("A sideboard with a coffee machine and cups on the opposite wall.",
         ["1 sideboard against_wall opposite_wall", "3 cup on sideboard"]),
        ("A table with a lamp and six cups in the corner.",
         ["1 dining_table in_corner corner", "6 cup on dining_table"]),
        ("A science classroom with five tables with four stools each and a sink at every table.", ["5 sink"]),
        # Two ends, and what is between two groups at walls.
        ("Barrels along the left wall, racks along the right wall, and a table with four glasses and a jug in between.",
         ["1 dining_table between barrel shelving_unit", "4 glass on dining_table"]),
        ("A table, a screen at one end and a credenza at the other.", ["1 credenza opposite wall_tv"]),
        ("A sofa against one wall and a bookcase against the other.",
         ["1 sofa against_wall one_wall", "1 bookcase against_wall opposite_wall"]),
        # Groups that are told in parts, and things that are each on one of their own.
        ("A lab with four stations along the wall, each consisting of a table and a stool.",
         ["4 dining_table against_wall wall", "4 stool around dining_table"]),
        ("A salon with four manicure stations in a line, each with two chairs.",
         ["4 manicure_station in_rows", "8 chair around manicure_station"]),
        ("Two sewing machines, each on its own table.", ["2 sewing_machine on dining_table"]),
        # What is told first of all that is listed, and lamps under which things stand.
        ("A piano. Opposite the piano, a loveseat and a floor lamp.",
         ["1 sofa opposite piano", "1 floor_lamp opposite piano"]),
        ("A sofa. To the left of the sofa, a lamp and a plant.", ["1 floor_lamp left_of sofa", "1 plant left_of sofa"]),
        ("A pool table under a long lamp.", ["1 pool_table under pendant_lamp"]),
        ("A sectional and three framed photos above it.", ["3 photo_frame above sofa"]),
        # What lies there together, and between whom.
        ("A pool table with two cues and a triangle on it.", ["2 cue on pool_table", "1 triangle on pool_table"]),
        ("Five washers along the left wall, five dryers along the right wall, and a folding table between them.",
         ["1 folding_table between washing_machine dryer"]),
        # What a text begins with says which room it is, and what a room belongs to is no thing in it.
        ("Inside of a photo booth, 1.1 m x 1.7 m: one stool.", ["1 stool"]),
        ("The kitchen of a food truck, 2 by 4.2 metres. A grill by the window.", ["1 grill next_to window"]),
        ("A partner's office at a law firm. A desk in the corner.", ["1 desk in_corner corner"]),
        ("Goal: the tray on the desk.", ["1 tray on desk"]),
        ("Pool table dead centre with three balls on it.", ["1 pool_table in_centre centre", "3 ball on pool_table"]),
        ("The table, a round one, is in the corner.", ["1 dining_table in_corner corner"]),
        ("The hamper is next to the wardrobe and it is still empty.", ["1 laundry_basket next_to wardrobe"]),
        ("Two stools by the door. Oh, and no chairs at all!", ["2 stool next_to door"]),
        ("Everything in this kitchen revolves around the range. It stands against the wall.",
         ["1 stove against_wall wall"]),
        # Lists: what ends one that is held, what is joined on something, and what two have that are one on the other.
        ("The cabinet contains five figurines and a sabre.", ["5 figurine inside cabinet", "1 sabre inside cabinet"]),
        ("On the desk an iron, a magnifying lamp and two paint pots.",
         ["1 magnifying_lamp on desk", "2 paint_can on desk"]),
        ("Two boxes, one on the other, by the door.", ["1 box next_to door", "1 box-2 next_to door", "1 box on box-2"]),
        ("A sofa with a magazine rack holding seven magazines next to it.",
         ["1 magazine_rack next_to sofa", "7 magazine inside magazine_rack"]),
        ("Three buckets near the door with a watering can beside them.", ["1 watering_can next_to bucket"]),
        # Parts of several: the last that were told apart, the next that is counted, the left of the last two.
        ("Five low tables. Two of the tables are set: a sign stands on each of those.", ["2 sign on coffee_table"]),
        ("Two sideboards. The first has a basket with eight apples. On the second there is a cake.",
         ["1 cake on sideboard-2"]),
        ("A mirror flanked by two sconces. Two baskets by the door. The left one has three umbrellas in it.",
         ["3 umbrella inside basket"]),
        ("Eight buckets - half of the buckets are blue and half grey.", ["4 bucket", "4 bucket-2"]),
        ("A bench, on it an unfinished violin. The finished violins, four of them, hang on the wall.",
         ["1 violin on bench", "4 violin-2 on wall"]),
        # So many as there are of others, wherever they are.
        ("Seven stools in front of the counter, and on the counter a bowl and a napkin per stool.",
         ["7 bowl on counter", "7 napkin on counter"]),
        ("Eight potter's wheels, and one apron per wheel hanging on the wall.", ["8 apron on wall"]),
        ("Eight wheels. The drying rack holds two bowls for each wheel.", ["16 bowl inside drying_rack"]),
        ("Six chairs around a table. Each place is laid with a plate and a cracker.",
         ["6 plate on dining_table", "6 cracker on dining_table"]),
        ("Twelve desks with a chair at each desk and nothing on any of them except one exam paper.",
         ["12 exam_paper on desk"]),
        ("A nightstand with nothing on it but a lamp.", ["1 table_lamp on nightstand"]),
        ("Mudroom for a family of five: a bench, and under the bench one basket per person.", ["5 basket under bench"]),
        ("The vanity unit by the door. A cabinet to the left of the vanity.", ["1 cabinet left_of vanity"]),
        ("Three tables, two of which wait to be cleared.", ["2 dining_table", "1 dining_table-2"]),
        ("Twelve desks. Nothing on the desks apart from one sheet of paper and one pencil apiece.",
         ["12 paper on desk", "12 pencil on desk"]),
        ("Three low tables. An iron kettle on two of the tables.", ["2 kettle on coffee_table"]),
        ("Three couches. Two are blue, the last one is black. On the black one lies a towel.",
         ["2 sofa", "1 towels on sofa-2"]),
        ("A stool. Two softboxes: a large one to the left of the stool, a small one to the right of it.",
         ["1 softbox left_of stool", "1 softbox-2 right_of stool"]),
        ("Four tables with five chairs at each. Twenty hooks on the wall, one per chair.", ["20 coat_hooks on wall"]),
        ("Two booths, each consisting of a table with two chairs.", ["2 dining_table", "4 chair around dining_table"]),
        ("Six bins in two colours, three red and three blue.", ["3 waste_bin", "3 waste_bin-2"]),
        ("A bedsit with everything in one room: a bed in the corner.", ["1 bed in_corner corner"]),
        # What lies between two, what a small thing holds, and where the list of it ends.
        ("A desk with a cart next to it, two sofas facing each other with a low table in between.",
         ["1 coffee_table between sofa"]),
        ("A cabinet with gloves and masks along the wall.", ["1 cabinet against_wall wall", "2 mask inside cabinet"]),
        ("A fridge covered with postcards, a sink full of plates.", ["3 plate inside sink"]),
        ("Living room for watching football: a low table with a bowl of crisps and six beer bottles.",
         ["6 beer_bottle on coffee_table"]),
        ("Two beds. The larger one has a pink blanket, the smaller one a yellow one.",
         ["1 blanket on bed", "1 blanket-2 on bed-2"]),
        ("A bookcase holding thirty books, a basket of toys at the foot of the bed.", ["1 basket at_foot_of bed"]),
        ("Three racks with 48 bottles each along the right wall, and a table.",
         ["3 shelving_unit against_wall right_wall", "144 bottle inside shelving_unit"]),
        ("A booth with a laptop and a lamp, speakers on both sides of the booth.", ["1 laptop on booth"]),
        # People sit where no thing is said to be; what something is for; of what the last of a list is told.
        ("The doctor sits behind the desk, two armchairs are in front of it.", ["2 armchair in_front_of desk"]),
        ("A mirror on the wall to check posture.", ["1 mirror on wall"]),
        ("A fridge and a sink by the wall. High table with four stools opposite.", ["4 bar_stool around high_table"]),
        ("Two washbasins with mirrors at the back.", ["2 washbasin against_wall far_wall"]),
        ("A couch with a lamp at its head.", ["1 floor_lamp next_to sofa"]),
        # Zones of the room have what is listed next; what is told of itself shares no other place.
        ("The room is a 5 m by 4 m bedroom. A wardrobe on the east wall.", ["1 wardrobe against_wall east_wall"]),
        ("Four tables, each with two chairs, a reading corner with a bookcase.", ["1 bookcase"]),
        ("A lamp, pictures along the wall and a poster on the wall behind each of two desks.",
         ["2 poster behind desk"]),
        ("Three tables, the first with bowls, the second with vases and the third with plates, ten of each.",
         ["10 bowl on dining_table", "10 vase on dining_table-2", "10 plate on dining_table-3"]),
        ("Six tables, a cake stand with scones in the middle of every table.", ["6 cake_stand on dining_table"]),
        ("Six booths along the window, each with two benches and a table.", ["12 bench around dining_table"]),
        ("Three statues stand by a wall; one of them is covered with a cloth.", ["1 cloth on statue"]),
        ("Five tables. One table has a lamp on it, each of the others has a vase.", ["4 vase on dining_table-2"]),
        ("A mic on a mic stand, a music stand in front of the mic stand.",
         ["1 music_stand in_front_of microphone_stand"]),
        ("Against the wall a workbench: a magnifying lamp, two paint pots.",
         ["1 magnifying_lamp on workbench", "2 paint_can on workbench"]),
        ("A café: five round tables, three with two chairs and two with four chairs, all under parasols.",
         ["6 chair around dining_table", "8 chair-2 around dining_table-2", "3 dining_table under parasol"]),
        ("A bathroom with a toilet and a shower. A sink is between the toilet and the shower and has a shelf above it.",
         ["1 wall_shelf above washbasin"]),
        ("A bike on a repair stand in the middle.", ["1 bicycle on repair_stand", "1 repair_stand in_centre centre"]),
        ("Three tables, an office chair and a stool at each, a lamp and a box of pens on each of them.",
         ["3 office_chair around dining_table", "3 stool around dining_table", "3 table_lamp on dining_table"]),
        ("The workbench has two saws, a truing stand and a tin of grease on it.",
         ["1 truing_stand on workbench", "1 tin_can on workbench"]),
        # What is parted by others, what is left and right of a thing, at the other end, or in one phrase.
        ("A room with three desks, separated by screens, each with a lamp on it.", ["3 desk_lamp on desk"]),
        ("A bed in the corner, bedside tables left and right.",
         ["1 nightstand left_of bed", "1 nightstand-2 right_of bed"]),
        ("Two beds with a nightstand and a phone between them.", ["1 nightstand between bed", "1 phone between bed"]),
        ("A closet with shelves for shoes on the left and an island with a tray on it in the middle.",
         ["1 kitchen_island in_centre centre", "3 shoes inside shelving_unit"]),
        ("A steel toilet and sink in the corner.", ["1 toilet in_corner corner"]),
        ("A stool by the door. A mop and a broom in the corner.",
         ["1 mop in_corner corner", "1 broom in_corner corner"]),
        ("On the counter there's a jar of pickles, salt and a stack of plates.", ["1 salt on counter"]),
        ("Art class: five easels.", ["5 easel"]),
        ("Three dress forms by the window wearing three jackets.", ["3 dress_form next_to window"]),
        ("A table with six chairs on each side and a lamp every two seats.", ["6 table_lamp on dining_table"]),
        ("A fireplace in the corner and a rug in front of the fire.", ["1 rug in_front_of fireplace"]),
        ("Four tables with two chairs each. On every table a vase and one glass per chair.",
         ["8 glass on dining_table"]),
        ("A sofa. A desk with a lamp and a radio, a bookcase on each side of the desk and a basket by the sofa.",
         ["1 basket next_to sofa"]),
        ("Three tables with three chairs each, a fireplace with two armchairs in front of it.",
         ["2 armchair in_front_of fireplace"]),
        ("Four metal shelves along the long walls, two on each side.", ["4 shelving_unit against_wall long_wall"]),
        ("A sofa for three and a teepee with two pillows inside next to it.", ["1 play_tent next_to sofa"]),
        ("A sculpture at each end of the room.", ["2 sculpture against_wall short_wall"]),
        ("Two tables, a white cloth and flowers on every table.", ["2 cloth on dining_table"]),
        ("Two tables with two chairs each, three rows of benches behind the tables.", ["9 bench behind dining_table"]),
        ("A round table for six. Each place has a plate and a napkin.",
         ["6 plate on dining_table", "6 napkin on dining_table"]),
        ("A sofa by the window, a table with a plant in front of the sofa.", ["1 coffee_table in_front_of sofa"]),
        # Sides of what is named, and "that" of what lies beside it.
        ("A mobile robot in the middle, a pallet with two boxes on it to the robot's right and a bin to its left.",
         ["1 pallet right_of mobile_robot", "2 box on pallet", "1 waste_bin left_of mobile_robot"]),
        ("A piano. Put a metronome on it and, to the left of that, a bust.", ["1 bust left_of metronome"]),
        ("Start with the piano: an upright one, against the wall.", ["1 piano against_wall wall"]),
        # What is said aside, what hangs there, what is stacked on one thing, and what a shelf is for.
        ("Two guitars - one of them electric - next to the bookcase.",
         ["1 guitar next_to bookcase", "1 guitar-2 next_to bookcase"]),
        ("A full-length mirror and three hooks on the walls.", ["1 standing_mirror on wall", "3 coat_hooks on wall"]),
        ("A washing machine with a dryer stacked on top of it.", ["1 dryer on washing_machine"]),
        ("An open shelf rather than a cabinet for his paint pots - there are six of them.",
         ["6 paint_can inside shelving_unit"]),
        ("A ball of dough on the counter and a rolling pin to the left of the dough.", ["1 rolling_pin left_of dough"]),
        # "Them" are not the one that has something; who sits at a table says how many chairs are at its sides.
        ("Five chairs along one wall, a low table with magazines in front of them.",
         ["1 coffee_table in_front_of chair"]),
        ("A desk with two monitors and a keyboard in front of them.", ["1 keyboard in_front_of monitor"]),
        ("The meeting room should seat eight: a long table, chairs on both long sides.",
         ["8 chair at_long_side conference_table"]),
        ("A table by the door, and two chairs that are round.", ["1 dining_table next_to door"]),
        ("An X-ray light box on the wall, 2 x stools and two X-ray tables.", ["1 light_box on wall", "2 stool"]),
        ("A shelf with towels. A glove box on a counter.", ["2 towels inside shelving_unit", "1 glove_box on counter"]),
    ],
)  # fmt: skip
def test_details_are_read(prompt: str, relations: list[str]) -> None:
    brief = read_brief(prompt, fill="named")
    assert set(relations) <= related(brief) | {f"{r.count} {r.key}" for r in brief.requests}
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "doubt"),
    [
        ("A flat: bed and desk share the same wall.", "the same wall"),
        ("A lamp within 20 cm of the bed.", "within 20 cm of the bed"),
        ("A home office under the stairs: a desk and a stool.", "under the stairs"),
        ("A bench facing each of the side walls.", "facing each of the side walls"),
        ("A bench with plant pots on and under it.", "on and under it"),
        ("A bar with two stools divides the room.", "divides the room"),
        ("A table in the corner, two chairs on the open sides.", "on the open sides"),
        ("Four mannequins along the window wall.", "the window wall"),
        ("A bed against the wall with the window.", "the wall with the window"),
        ("Four tables in two rows, a watering can at the end of each row.", "at the end of each row"),
        ("A desk with its short side against the wall.", "its short side"),
        ("Three tables and a vase on the tables.", "which of them"),
        ("A lamp around the table.", "only one"),
        ("Plates above the desk.", "on what"),
        ("A piano on a side table.", "hardly"),
        ("Two armchairs, a sofa, a rug under all of them.", "under all of them"),
        ("A dining table with six chairs, with one chair missing.", "one chair missing"),
        ("Cakes in a glass counter.", "in a glass counter"),
        ("Shelves with paint.", "paint"),
        ("A rug in the middle and a sofa on its north side.", "its north side"),
        ("A TV mounted high on the wall.", "high"),
        ("A sink on the adjacent wall.", "the adjacent wall"),
        ("A bedroom with a tatami floor.", "a tatami floor"),
        ("A wall of six monitors.", "A wall of"),
        ("A freezer display, five stools at the counter.", "display"),
        ("A dojo with mats covering the floor.", "covering the floor"),
        ("A bed without a headboard.", "a headboard"),
        ("A table and a red runner across the table.", "across the table"),
        ("A fridge with magnets on it.", "stuck to it"),
        ("A fridge, a stove and a sink along the wall with the sink in the middle.", "the sink in the middle"),
        ("Twelve chairs arranged in a semicircle facing the piano.", "in a semicircle"),
        ("Ten easels in a semicircle around a platform.", "in a semicircle"),
        ("Six chairs in a half circle around the stove.", "in a half circle"),
        ("Two lamps at 45 degrees to the backdrop.", "45 degrees"),
        ("Ten bookcases forming three aisles.", "forming three aisles"),
        ("A table saw and a drill press arranged in a triangle.", "in a triangle"),
        ("Four clusters of four desks.", "clusters of four desks"),
        ("Two desks and a receptionist.", "a receptionist"),
        ("A round table with three chairs on one side.", "on one side"),
        ("Eight tables with four chairs each, except the two by the window, which have two.", "which have two"),
        ("Each place has a plate.", "Each place"),
        ("Six desks, each with a chair. The table has a jug on it but no chair.", "no chair"),
        ("Homework nook under the stairs (150 cm by 210 cm): a desk.", "under the stairs"),
    ],
)
def test_what_is_not_done_is_said(prompt: str, doubt: str) -> None:
    assert doubt in "; ".join(read_brief(prompt, fill="named").unknown)


@pytest.mark.parametrize(
    ("prompt", "room"),
    [
        ("In the corner of the bedroom stands a chair.", "bedroom"),
        ("A gym room with two treadmills.", "gym"),
        ("A judge's chambers with a desk.", "office"),
        ("A bedroom for twins.", "kids_room"),
        ("Front room of a pizzeria: a brick oven by the door.", "pizzeria"),
        ("Fetch-and-carry scene in a studio kitchen: a mug on the counter.", "kitchen"),
        ("The geography classroom measures 7.5 by 9 metres.", "classroom"),
    ],
)
def test_the_room_is_named_in_passing(prompt: str, room: str) -> None:
    assert read_brief(prompt).room_type == room


@pytest.mark.parametrize(
    ("prompt", "beds"),
    [
        ("A bedroom for twins.", {"bed": 2}),
        ("The twins' bedroom.", {"bed": 2}),
        ("A nursery for triplets.", {"crib": 3}),
        ("A bedroom for twins with two cribs.", {"crib": 2}),
        ("A bedroom with a futon.", {"futon": 1}),
    ],
)
def test_a_word_for_people_says_how_many_beds(prompt: str, beds: dict[str, int]) -> None:
    lain_on = ("bed", *load_habits().group("lain_on"))
    assert {r.category: r.count for r in read_brief(prompt).requests if r.category in lain_on} == beds


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("An ottoman that stands anywhere but in the middle.", "in_centre"),
        ("The chair is in the corner instead of in the middle.", "in_centre"),
        ("The bed is by the window rather than against the wall.", "against_wall"),
    ],
)
def test_a_place_that_something_is_not_at(prompt: str, kind: str) -> None:
    assert [r.kind for r in read_brief(prompt, fill="named").relations if r.negated] == [kind]


def test_the_size_of_a_cubby_is_not_that_of_the_stairs() -> None:
    brief = read_brief("Reading cubby under the stairs, 1.4 m by 2 m: a mattress with two pillows on it.", fill="named")
    assert (brief.width, brief.depth, brief.unknown) == (1.4, 2.0, ("under the stairs",))


def test_a_basket_before_one_is_not_on_the_other() -> None:
    prompt = "Two washing machines, one with a dryer on top, a basket in front of the other."
    relations = read_brief(prompt, fill="named").relations
    assert [(r.kind, r.anchors) for r in relations if r.subject == "basket"] == [
        ("in_front_of", ("washing_machine-2",))
    ]


def test_each_student_is_one_at_each_of_the_tables() -> None:
    brief = read_brief("A classroom with five tables for four students each. Each student gets a chair.", fill="named")
    assert counted(brief)["chair"] == 20


def test_colours_are_told_after_paint() -> None:
    dresser = read_brief("A dresser painted yellow.", fill="named").requests[0]
    assert (dresser.category, dresser.attributes) == ("dresser", ("yellow",))


def test_a_table_is_round() -> None:
    table = read_brief("A table and two chairs. The table is round. The chairs are stools.", fill="named").requests[0]
    assert table.attributes == ("round",)


def test_what_something_is_for_is_no_thing() -> None:
    brief = read_brief("Four stools, a bin for paper, one for glass and one for plastic.", fill="named")
    assert [(r.category, r.count) for r in brief.requests] == [("stool", 4), *[("waste_bin", 1)] * 3]


def test_a_place_for_things_is_not_understood() -> None:
    assert read_brief("A hallway with a mirror and a place for umbrellas.").unknown == ("a place for umbrellas",)


@pytest.mark.parametrize(("room", "made"), [("lab", "lab_bench"), ("workshop", "workbench"), ("hallway", "bench")])
def test_a_bench_is_what_one_uses_there(room: str, made: str) -> None:
    assert [r.category for r in read_brief(f"A {room} with a bench.", fill="named").requests] == [made]


def test_a_table_of_glass_is_a_glass_table() -> None:
    assert read_brief("A table of dark glass.").requests[0].attributes == ("glass",)


def test_what_stands_on_stands_of_an_unknown_kind() -> None:
    brief = read_brief("A workshop with two bikes on repair stands in the middle.", fill="named")
    assert {r.category: r.count for r in brief.requests} == {"bicycle": 2, "repair_stand": 2}


def test_a_table_of_two_is_for_two() -> None:
    tables = [
        r for r in read_brief("Six tables of four and two tables of two.").requests if r.category == "dining_table"
    ]
    assert [(r.count, r.attributes) for r in tables] == [(6, ("for-4",)), (2, ("for-2",))]


@pytest.mark.parametrize(
    ("prompt", "lost"),
    [
        ("Six rows of eight chairs, the last row of which is red.", "the last row of"),
        ("A round table for four, the chairs all different colours, and a clock.", "all different colours"),
        ("Two rows of lockers and benches on both long sides of each.", "on both long sides of each"),
        ("Eight tables in two columns of four, and a lamp on each table in the first column.", "in the first column"),
    ],
)
def test_rows_and_colours_of_nothing_single_are_not_understood(prompt: str, lost: str) -> None:
    assert lost in read_brief(prompt).unknown


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("The lobby of a grand hotel with two sofas.", {"sofa": 2}),
        ("A lounge in a grand house with a piano.", {"piano": 1}),
        ("A bathroom with a double vanity with two sinks and a toilet.", {"vanity": 1, "toilet": 1}),
        ("A bathroom. The vanity has two sinks and a mirror.", {"vanity": 1, "mirror": 1}),
        ("A dresser with six drawers and a bed.", {"dresser": 1, "bed": 1}),
        ("One green and one black trash can.", {"waste_bin": 2}),
        ("Two small and one large vase.", {"vase": 3}),
        ("A wooden, a red and a metal stool.", {"stool": 3}),
        ("Two chairs, one red and one blue.", {"chair": 2}),
        ("den w/o a couch, w/ a low table.", {"coffee_table": 1}),
        ("A living room with a grand and a sofa.", {"grand_piano": 1, "sofa": 1}),
        ("A bed and a nightstand holding reading glasses.", {"bed": 1, "nightstand": 1, "reading_glasses": 1}),
        ("Two nightstands with reading lamps.", {"nightstand": 2, "table_lamp": 2}),
        ("An armchair with a reading lamp beside it.", {"armchair": 1, "floor_lamp": 1}),
        ("A safety light pole and a sofa.", {"safety_light_pole": 1, "sofa": 1}),
        ("A fluffy white rug, a Persian one.", {"rug": 1}),
        ("A wood-burner and a wooden bench.", {"wood_burner": 1, "bench": 1}),
        ("A living room that hasn't changed since the 70s, with the kind of sofa we like.", {"sofa": 1}),
        ("A bed, mountains of books.", {"bed": 1, "book": 3}),
    ],
)
def test_plain_words_name_what_they_should(prompt: str, things: dict[str, int]) -> None:
    brief = read_brief(prompt, fill="named")
    assert counted(brief) == things
    assert brief.unknown == ()


def test_ends_are_of_what_they_end() -> None:
    brief = read_brief("A lab with four fume hoods, and two benches with sinks at the ends.", fill="named")
    assert not any("fume_hood" in relation.anchors for relation in brief.relations)


def test_mats_face_what_is_flanked_and_are_nowhere_else() -> None:
    brief = read_brief("A yoga room with a statue flanked by two candles, and twelve mats facing it.")
    assert [(r.kind, r.anchors) for r in brief.relations if r.subject == "yoga_mat"] == [("facing", ("statue",))]


def test_what_a_table_is_made_of_is_no_thing() -> None:
    brief = read_brief("A low table made of crates.", fill="named")
    assert [(r.category, r.unshown) for r in brief.requests] == [("coffee_table", ("made of crates",))]


@pytest.mark.parametrize(
    ("prompt", "room", "toilets"),
    [
        ("A tiny loo under the stairs, 0.9 by 1.7 m: a toilet against the back wall.", "toilet_room", 1),
        ("loo, 0.9 x 1.7 m: toilet and basin", "toilet_room", 1),
        ("A toilet next to the sink, and a mirror.", "room", 1),
    ],
)  # fmt: skip
def test_a_closet_that_is_called_after_what_is_in_it_is_a_room(prompt: str, room: str, toilets: int) -> None:
    brief = read_brief(prompt, fill="named")
    assert brief.room_type == room
    assert sum(r.count for r in brief.requests if r.category == "toilet") == toilets


@pytest.mark.parametrize(
    ("prompt", "looks"),
    [
        ("A table that is round by the door, and two chairs.", {"dining_table": ("round",), "chair": ()}),
        ("A bed that is not big.", {"bed": ("small",)}),
        ("The table is round, and the chairs are not big.", {"dining_table": ("round",), "chair": ("small",)}),
        ("It's not a big room. A bed.", {"bed": ()}),
    ],
)
def test_what_is_said_not_to_be_big_is_small(prompt: str, looks: dict[str, tuple[str, ...]]) -> None:
    brief = read_brief(prompt, fill="named")
    found = {r.category: tuple(a for a in r.attributes if not a.startswith("for-")) for r in brief.requests}
    assert found == looks
    assert "large" not in brief.style


def test_a_look_that_is_denied_is_said() -> None:
    assert read_brief("Two chairs. They are not red.", fill="named").unknown == ("red",)
    assert read_brief("Not a big room, with a bed.").style == ("small",)


@pytest.mark.parametrize("prompt", ["A soft round rug.", "A table and a strange round rug.", "Two shaggy, round rugs."])
def test_round_after_a_word_that_is_no_thing_is_a_shape(prompt: str) -> None:
    rug = read_brief(prompt, fill="named").requests[-1]
    assert rug.category.endswith("rug")
    assert "round" in rug.attributes


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A chair with a blanket over it", "1 blanket on chair"),
        ("Two beds, each with a throw over it", "2 blanket on bed"),
        ("A sofa. A wool blanket lies over the sofa.", "1 blanket on sofa"),
        ("A quilt hangs on the wall over the bed", "1 blanket above bed"),
        ("A bed with a shelf over it", "1 wall_shelf above bed"),
    ],
)
def test_a_cloth_lies_over_furniture(prompt: str, relation: str) -> None:
    brief = read_brief(prompt)
    assert relation in related(brief)
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "categories"),
    [
        ("A crystal ball on the table.", {"crystal_ball", "dining_table"}),
        ("A chocolate bar on the desk.", {"chocolate_bar", "desk"}),
        ("Smack in the middle, a round table.", {"dining_table"}),
        ("On the counter you'd find a cash register.", {"counter", "cash_register"}),
        ("A class for grown-ups with a desk.", {"desk"}),
        ("A room, a bit dark, with a bed.", {"bed"}),
        ("A bookcase full of train magazines.", {"bookcase", "train_magazine"}),
        ("A low table with four cushions around it.", {"coffee_table", "floor_cushion"}),
    ],
)
def test_turns_of_phrase_ask_for_nothing_else(prompt: str, categories: set[str]) -> None:
    brief = read_brief(prompt)
    assert {request.category for request in brief.requests if request.asked} == categories
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "untold"),
    [
        ("A lobby with everything orange and a sofa.", ("everything orange",)),
        ("A room used to train a robot. A sofa.", ("used to train a robot",)),
    ],
)
def test_what_everything_is_like_and_what_a_room_is_used_for_are_told(prompt: str, untold: tuple[str, ...]) -> None:
    brief = read_brief(prompt)
    assert brief.unknown == untold
    assert {request.category for request in brief.requests if request.asked} == {"sofa"}


def test_an_overhead_camera_hangs() -> None:
    brief = read_brief("Overhead camera hung from the ceiling above the desk.")
    assert related(brief) >= {"1 camera on ceiling", "1 camera above desk"}


def test_what_is_under_a_thing_on_the_wall_is_not_on_the_wall() -> None:
    brief = read_brief("On the wall is a clock, under the clock a vase on a stand.")
    assert related(brief) == {"1 clock on wall", "1 vase under clock", "1 vase on side_table"}


@pytest.mark.parametrize(
    ("prompt", "room"),
    [
        ("The vestry of a church, 3 x 4 m. A safe in the corner.", "vestry"),
        ("Bingo night in the parish hall: six tables.", "community_hall"),
        ("Language lab, five desks.", "language_lab"),
        ("Vertical farm, 6 x 8 m. Four crates.", "vertical_farm"),
        ("Airport security lane, 7 by 9 m. Two suitcases.", "security_checkpoint"),
        ("A bunker with four bunk beds.", "shelter"),
        ("Tailor's workroom, 4 x 3 m. A table.", "sewing_room"),
        ("A tailor's with a table.", "sewing_room"),
        ("An old school barber's with a radio.", "barber_shop"),
        ("At the barber's there are three chairs.", "barber_shop"),
        ("At the vet's, two chairs.", "vet_clinic"),
        ("At the dentist's there is a sink.", "dental_surgery"),
        ("At the office, two printers.", "office"),
    ],
)
def test_further_kinds_of_rooms(prompt: str, room: str) -> None:
    brief = read_brief(prompt)
    assert brief.room_type == room
    assert not brief.unknown


@pytest.mark.parametrize(
    "said",
    [
        "0 chairs",
        "zero chairs",
        "nil chairs",
        "nought chairs",
        "exactly 0 chairs",
        "at most 0 chairs",
        "fewer than 1 chairs",
        "chairs x 0",
        "0x chairs",
        "chairs: 0",
        "chairs (0)",
        "chairs: none",
        "chairs: none at all",
        "chairs: zero",
        "no chairs: 0",
        "number of chairs: 0",
    ],
)
def test_a_count_of_nothing_bars_a_thing(said: str) -> None:
    brief = read_brief(f"A study with a desk, {said}, and two lamps")
    assert brief.excluded == ("chair",)
    assert not {"chair", "office_chair"} & {request.category for request in brief.requests}
    assert {("desk", 1), ("desk_lamp", 2)} <= {(request.category, request.count) for request in brief.requests}
    assert not brief.unknown


def test_a_nought_that_counts_no_thing_bars_nothing() -> None:
    assert read_brief("A dining room with a table and 0 to 2 chairs").excluded == ()
    assert read_brief("A desk 0 cm from the wall and a chair").excluded == ()
    assert [opening.count for opening in read_brief("A bedroom with a bed, windows: 0").openings] == [0]


def test_a_list_of_entries_with_their_numbers_is_no_numbered_list() -> None:
    brief = read_brief("A study. Desk: 1. Chairs: 3. Stools: 0. Bookcases: 2.")
    counted = {(request.category, request.count) for request in brief.requests}
    assert {("desk", 1), ("chair", 3), ("bookcase", 2)} <= counted
    assert brief.excluded == ("stool",)
    listed = read_brief("On the desk: 1. a lamp. 2. a monitor.")
    assert {(request.category, request.count) for request in listed.requests} == {
        ("desk", 1),
        ("desk_lamp", 1),
        ("monitor", 1),
    }


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("A dining room for eight with a sideboard and a lamp over the table.", {"dining_table": 1, "chair": 8}),
        ("A dining room for eight with a table and chairs.", {"dining_table": 1, "chair": 8}),
        ("A dining room for six with two tables.", {"dining_table": 2, "chair": 6}),
        ("An office for six people with desks, monitors and chairs.", {"desk": 6, "monitor": 6, "chair": 6}),
        ("A small shower room with a toilet and a basin.", {"shower_cabin": 1, "toilet": 1, "washbasin": 1}),
        ("A waiting room with ten chairs and a reception desk.", {"chair": 10, "office_chair": None}),
    ],
)
def test_what_the_name_of_a_room_and_its_people_imply(prompt: str, counts: dict[str, int]) -> None:
    found = {r.category: r.count for r in read_brief(prompt).requests}
    assert {name: found.get(name) for name in counts} == counts


def test_a_till_at_a_counter_is_on_it_and_a_printer_on_nobodys_desk() -> None:
    brief = read_brief("A shop with a counter by the door and a till at the counter.")
    assert "1 cash_register on counter" in related(brief)
    assert not brief.unknown
    office = read_brief("An office for four people with desks, chairs and a printer.")
    assert "filing_cabinet" in {r.category for r in office.requests}


def test_shelves_along_the_walls_are_shared_out_over_several() -> None:
    brief = read_brief("A bookshop with shelves along the walls, and a counter.")
    assert [r.spread > 1 for r in brief.relations if r.subject == "bookcase"] == [True]


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        # What is told in passing, of the other of two, and of one side and the other.
        ("Two desks. Each desk has a monitor and a mouse on it, with the mouse in front of the monitor.",
         ["2 mouse on desk", "2 mouse in_front_of monitor"]),
        ("A shelf with a kettle, a bowl and a jug, with the bowl between the other two.",
         ["1 bowl between kettle jug"]),
        ("A table with a bench on one side and two stools on the other.",
         ["1 bench in_front_of dining_table", "2 stool behind dining_table"]),
        ("A plant on the left of the door, another on the right of it.",
         ["1 plant left_of door", "1 plant-2 right_of door"]),
        ("One boot under the bench, the other boot near the door.", ["1 boots under bench", "1 boots-2 near door"]),
        ("A bench in front of a piano. On the bench? A cushion.", ["1 pillow on bench"]),
        ("A table - round, of course - stands by the door.", ["1 dining_table next_to door"]),
        # Numbers that are told around the noun, and what is listed with what carries it.
        ("Vases, at least five, on a shelf.", ["5 vase on shelving_unit"]),
        ("Two printers on their own desks.", ["2 desk", "2 printer on desk"]),
        ("Three rows by four columns of chairs.", ["12 chair"]),
        ("Two kilns, one in each corner.", ["2 kiln in_corner corner"]),
        ("An office with four desks, monitors and chairs.", ["4 monitor"]),
        ("A desk with a lamp. A clock, a cup and a phone next to the lamp.", ["1 clock on desk", "1 phone on desk"]),
        ("A globe is on the desk, to the left of a mug.", ["1 cup on desk"]),
        ("A till at the counter by the door.", ["1 cash_register on counter"]),
        ("A small table for a radio.", ["1 radio on dining_table"]),
        ("An x-ray machine and a smal round tabel.", ["1 x_ray_machine", "1 dining_table"]),
        ("A taxi in the corner, a jack next to the car.", ["1 jack next_to taxi"]),
        ("A nightstand with a pair of glasses on it.", ["1 eyeglasses on nightstand"]),
    ],
)  # fmt: skip
def test_what_is_told_around_a_thing_is_read(prompt: str, relations: list[str]) -> None:
    brief = read_brief(prompt, fill="named")
    assert set(relations) <= related(brief) | {f"{r.count} {r.key}" for r in brief.requests}


@pytest.mark.parametrize(
    "prompt",
    [
        "A small table with two chairs and a wardrobe.",
        "A flat with a kitchen and a sofa.",
        "Toys scattered on the floor.",
        "A living room with a 2-seat couch next to the door.",
    ],
)
def test_what_is_understood_is_not_doubted(prompt: str) -> None:
    assert not read_brief(prompt).unknown


def test_a_sofa_for_two_draws_no_chairs() -> None:
    brief = read_brief("A living room with a 2-seat couch next to the door.")
    assert not any("chair" in request.category for request in brief.requests if request.count > 1)


@pytest.mark.parametrize(
    ("prompt", "room", "things"),
    [
        ("Open plan living, kitchen and dining area.", "living_room", {"sofa", "fridge", "dining_table"}),
        ("A living/dining room with a sofa, a table and six chairs.", "living_room", {"sofa", "dining_table"}),
        ("A flat with living, sleeping and working areas.", "studio", {"sofa", "bed", "desk"}),
        ("A combined kitchen and dining room.", "kitchen", {"fridge", "kitchen_table"}),
        ("An office with eight desks and a sofa area.", "office", {"sofa", "desk"}),
        ("A kitchen and dining table.", "kitchen", {"dining_table"}),
    ],
)
def test_rooms_that_are_several_at_once_have_what_each_is_for(prompt: str, room: str, things: set[str]) -> None:
    brief = read_brief(prompt)
    assert brief.room_type == room
    assert things <= {request.category for request in brief.requests}
    assert not brief.unknown

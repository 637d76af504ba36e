"""Every tool, in the order in which an agent reads of them."""

from thinkblox.serving.placing_tools import (
    AnswerTool,
    AskExpertTool,
    MoveTool,
    ObserveTool,
    PlaceTool,
    RemoveTool,
    ReplaceTool,
    SkipTool,
    SwapTool,
    TurnTool,
    WantTool,
)
from thinkblox.serving.room_tools import (
    CheckFileTool,
    CloseRoomTool,
    ListCategoriesTool,
    ListFilesTool,
    ListObjectsTool,
    ListRoomsTool,
    OpenRoomTool,
    RenderTool,
    SaveTool,
    StartRoomTool,
    VerifyTool,
)
from thinkblox.serving.tool import Tool

TOOLS: dict[str, type[Tool]] = {
    tool.called(): tool
    for tool in (
        StartRoomTool,
        OpenRoomTool,
        ObserveTool,
        AnswerTool,
        PlaceTool,
        MoveTool,
        TurnTool,
        ReplaceTool,
        RemoveTool,
        SwapTool,
        AskExpertTool,
        WantTool,
        SkipTool,
        VerifyTool,
        RenderTool,
        SaveTool,
        CheckFileTool,
        ListRoomsTool,
        ListObjectsTool,
        ListCategoriesTool,
        ListFilesTool,
        CloseRoomTool,
    )
}
"""By name."""

"""Every tool, in the order in which an agent reads of them."""

from thinkblox.serving.placing_tools import (
    Answer,
    AskExpert,
    Move,
    Observe,
    Place,
    Remove,
    Replace,
    Skip,
    Swap,
    Turn,
    Want,
)
from thinkblox.serving.room_tools import (
    CheckFile,
    CloseRoom,
    ListCategories,
    ListFiles,
    ListObjects,
    ListRooms,
    OpenRoom,
    Render,
    Save,
    StartRoom,
    Verify,
)
from thinkblox.serving.tool import Tool

TOOLS: dict[str, type[Tool]] = {
    tool.called(): tool
    for tool in (
        StartRoom,
        OpenRoom,
        Observe,
        Answer,
        Place,
        Move,
        Turn,
        Replace,
        Remove,
        Swap,
        AskExpert,
        Want,
        Skip,
        Verify,
        Render,
        Save,
        CheckFile,
        ListRooms,
        ListObjects,
        ListCategories,
        ListFiles,
        CloseRoom,
    )
}
"""By name."""

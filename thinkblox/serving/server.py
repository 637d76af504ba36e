"""The tools over the Model Context Protocol, on stdin and stdout."""

import contextlib
import sys
from base64 import b64encode
from collections.abc import Callable
from threading import Thread
from typing import TYPE_CHECKING, Any

from thinkblox.errors import InputError
from thinkblox.png import png_of
from thinkblox.serving.calls import Answered, call
from thinkblox.serving.desk import Desk
from thinkblox.serving.root import Root
from thinkblox.serving.tools import TOOLS
from thinkblox.version import package_version

if TYPE_CHECKING:
    from mcp.server import Server
    from mcp.types import CallToolResult

INSTRUCTIONS = (
    "Furnish rooms object by object; a physics simulation measures every placement before it counts. start_room with a"
    " prompt, then for each object: observe, think, and place it or give your reasoning and answer to `answer`. What is"
    " not valid changes nothing and comes back with numbers and a shift that would help: answer again, move what is in"
    " the way, or skip it. At the end verify and save. Metres; x east, y north, z up; yaw in degrees counter-clockwise,"
    " 0 = the front faces +x. Files are relative to one root folder."
)


def serve(root: Root) -> None:
    """Serve one agent until it is gone; nothing but the protocol is written to stdout.

    Raises:
        InputError: the SDK is not installed.
    """
    try:
        import anyio
        from mcp.server.stdio import stdio_server
    except ImportError as error:
        raise InputError(f"the MCP server needs the MCP SDK ({error}); pip install 'thinkblox[mcp]'") from None

    async def serving() -> None:
        server = tool_server(Desk(root))
        async with stdio_server() as (incoming, outgoing):
            await server.run(incoming, outgoing, server.create_initialization_options())

    # The SDK takes the process's own stdout, and turns what anything else prints there to stderr.
    with contextlib.redirect_stdout(sys.__stdout__):
        try:
            _stoppable(lambda: anyio.run(serving))
        except* BrokenPipeError:
            pass  # whoever asked is gone


def _stoppable(work: Callable[[], None]) -> None:
    """Do work in a thread, so that a signal ends this one, though the other waits for a line that never comes."""
    faults: list[BaseException] = []

    def whole() -> None:
        try:
            work()
        except BaseException as error:
            faults.append(error)

    # What it starts inherits that the process does not wait for it.
    thread = Thread(target=whole, daemon=True)
    thread.start()
    thread.join()
    if faults:
        raise faults[0]


def tool_server(desk: Desk) -> "Server[Any]":
    """A server of the tools for the rooms of one session; calls are done one after the other."""
    import anyio
    from anyio import to_thread
    from mcp import types
    from mcp.server import Server, ServerRequestContext

    one_at_a_time = anyio.CapacityLimiter(1)
    tools = [
        types.Tool(
            name=name,
            description=tool.says(),
            input_schema=tool.schema(),
            annotations=types.ToolAnnotations(
                read_only_hint=tool.reads, destructive_hint=name == "close_room", open_world_hint=False
            ),
        )
        for name, tool in TOOLS.items()
    ]

    async def list_tools(
        context: ServerRequestContext[Any], params: types.PaginatedRequestParams | None
    ) -> types.ListToolsResult:
        return types.ListToolsResult(tools=tools)

    async def call_tool(
        context: ServerRequestContext[Any], params: types.CallToolRequestParams
    ) -> types.CallToolResult:
        answered = await to_thread.run_sync(call, desk, params.name, params.arguments, limiter=one_at_a_time)
        return _result(answered)

    return Server(
        "thinkblox",
        version=package_version(),
        title="ThinkBLOX",
        instructions=INSTRUCTIONS,
        on_list_tools=list_tools,
        on_call_tool=call_tool,
    )


def _result(answered: Answered) -> "CallToolResult":
    from mcp import types

    content: list[types.ContentBlock] = [
        types.TextContent(text=part)
        if isinstance(part, str)
        else types.ImageContent(data=b64encode(png_of(part)).decode(), mime_type="image/png")
        for part in answered.said.parts
    ]
    return types.CallToolResult(content=content, structured_content=answered.said.data, is_error=not answered.done)

/**
 * A client of Foxglove's WebSocket protocol ({@code foxglove.sdk.v1} and {@code foxglove.websocket.v1}), usable alone:
 * {@code FoxgloveClient} hears which channels and services a server has, receives of a channel only while it is
 * subscribed, publishes, calls services, reads and sets parameters. Payloads are bytes of the encoding that a channel
 * names; this library knows none of them.
 */
package org.robotui.foxglove;

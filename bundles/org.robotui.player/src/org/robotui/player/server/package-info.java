/**
 * A Player server for stock clients. {@link org.robotui.player.server.PlayerServer} has devices, each with a
 * {@link org.robotui.player.server.DeviceHandler}, and sends what is published to the clients that opened them.
 */
package org.robotui.player.server;

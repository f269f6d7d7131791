/**
 * A client of Player servers. {@link org.robotui.player.client.PlayerClient} is the way in: it keeps the link, and
 * gives {@link org.robotui.player.client.PlayerDevice}s, which subscribe, command and ask. No call blocks; how one
 * ended is an {@link org.robotui.net.call.Outcome}.
 *
 * <p>Usable alone: it needs {@code org.robotui.net}, what the protocol libraries share, and SLF4J.
 */
package org.robotui.player.client;

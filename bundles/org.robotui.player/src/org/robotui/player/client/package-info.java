/**
 * A client of Player servers. {@link org.robotui.player.client.PlayerClient} is the way in: it keeps the link, and gives
 * {@link org.robotui.player.client.PlayerDevice}s, which subscribe, command and ask. No call blocks.
 */
package org.robotui.player.client;

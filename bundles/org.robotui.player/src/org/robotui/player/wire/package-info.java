/**
 * Player's messages as bytes: headers, XDR, the greeting. Everything that comes from a peer is checked before it is
 * believed.
 */
package org.robotui.player.wire;

/** The devices of a server: which ports they have, and what is made of their data. */
package org.robotui.rfic.player.internal.device;

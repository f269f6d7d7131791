/** The robot interface to Player: devices of a server become ports, by its list of devices. */
package org.robotui.rfic.player.internal;

/** Requests to devices, and looking at what a server has. */
package org.robotui.rfic.player.internal.call;

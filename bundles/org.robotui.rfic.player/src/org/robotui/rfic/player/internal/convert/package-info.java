/** Values of Player as data, and back. Pure functions. */
package org.robotui.rfic.player.internal.convert;

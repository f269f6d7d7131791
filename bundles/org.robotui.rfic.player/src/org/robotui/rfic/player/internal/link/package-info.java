/** The link to a server, its clock, and all that is offered through it. */
package org.robotui.rfic.player.internal.link;

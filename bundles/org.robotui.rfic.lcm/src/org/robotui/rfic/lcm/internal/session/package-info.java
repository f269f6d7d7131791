/** One open connection: its channels, and what is offered of them. */
package org.robotui.rfic.lcm.internal.session;

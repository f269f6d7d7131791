/** What is asked of ports, and what a name server lists. */
package org.robotui.rfic.yarp.internal.call;

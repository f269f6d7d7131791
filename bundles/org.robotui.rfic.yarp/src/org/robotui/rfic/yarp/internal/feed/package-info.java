/** Ports as streams and commands: which there are, who wants them, and what drives the robot. */
package org.robotui.rfic.yarp.internal.feed;

/** Robots of ROS 1 and ROS 2 behind a rosbridge. */
package org.robotui.rfic.rosbridge.internal;

/** The type of robot interfaces to Gazebo, and its settings. */
package org.robotui.rfic.gazebo.internal;

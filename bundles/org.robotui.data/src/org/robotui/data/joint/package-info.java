/** Joints: their states, commands, trajectories, and the model of the robot that they move. */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.data.joint;

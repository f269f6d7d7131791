/**
 * Records of the types that robots of RoboFrame have in common, as {@code org.robotui.roboframe} defines them: in
 * metres, radians and seconds. The original framework had types of each team; these are ours.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.message.roboframe;

/**
 * The brain of a robot: it hosts the bodymap, knows the roblets by their beacons, and acts by rules. It has threads of
 * its own from a factory that it is given; rules run on one of them.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roblets.brain;

/**
 * Conditions about what robots say, as users write them: read once, and asked again and again, of a robot that is there
 * or of a recording.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.condition;

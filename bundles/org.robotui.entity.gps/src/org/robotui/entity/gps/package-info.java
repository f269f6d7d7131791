/**
 * Places on the earth (WGS 84): on a plane of metres that touches it, as words, the shortest way between two of them,
 * and the entity that draws a receiver with the way it has gone.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.entity.gps;

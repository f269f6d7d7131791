/**
 * A grid map, drawn from tiles of a pyramid, so that its size does not matter.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.entity.gridmap;

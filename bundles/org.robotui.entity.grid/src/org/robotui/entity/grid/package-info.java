/**
 * A metric grid and a scale bar.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.entity.grid;

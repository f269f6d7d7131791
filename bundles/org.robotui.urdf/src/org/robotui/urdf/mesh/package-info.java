/**
 * Meshes of STL, OBJ and COLLADA files as immutable records. Nothing is allocated that the bytes of a file cannot fill.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.urdf.mesh;

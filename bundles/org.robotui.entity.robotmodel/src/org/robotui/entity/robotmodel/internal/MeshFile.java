package org.robotui.entity.robotmodel.internal;

import java.util.Map;
import org.robotui.gl.shape.Texture;
import org.robotui.urdf.mesh.Mesh;

/**
 * What was in a file.
 *
 * @param mesh the surface
 * @param textures that could be read, by their names in the parts
 */
record MeshFile(Mesh mesh, Map<String, Texture> textures) {}

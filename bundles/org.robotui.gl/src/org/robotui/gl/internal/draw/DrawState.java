package org.robotui.gl.internal.draw;

import java.util.Optional;
import org.robotui.gl.internal.gpu.GpuTexture;
import org.robotui.gl.shape.Rgba;

/**
 * One part in one picture.
 *
 * @param eyeFromShape where it is
 * @param clipFromShape where it is in the picture
 * @param color of its material
 * @param lit in light
 * @param texture a picture on it
 * @param selected drawn as such
 * @param pale how much of the background is mixed in, 0 to 1
 * @param near depth of what is nearest to the eye
 * @param far depth of what is farthest
 * @param id of the part where it is searched, from 1
 */
public record DrawState(
    Matrix eyeFromShape,
    Matrix clipFromShape,
    Rgba color,
    boolean lit,
    Optional<GpuTexture> texture,
    boolean selected,
    float pale,
    double near,
    double far,
    int id) {}

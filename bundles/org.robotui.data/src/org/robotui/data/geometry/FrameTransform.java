package org.robotui.data.geometry;

import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;

/**
 * How one frame lies in another.
 *
 * @param parent the frame that carries
 * @param child the frame that is carried
 * @param stamp when it was so
 * @param parentFromChild the transform
 * @param fixed true where it never changes
 */
public record FrameTransform(FrameId parent, FrameId child, Stamp stamp, RigidTransform parentFromChild,
    boolean fixed) {}

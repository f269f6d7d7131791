package org.robotui.testkit;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformBuffer;
import org.robotui.geometry.TransformLookup;

/** Frames that a test fixes. */
public final class FakeFrames implements Frames {
  private final TransformBuffer<FrameId> buffer = new TransformBuffer<>();

  /**
   * Fixes a frame in another, for all times.
   *
   * @param parent the frame that carries
   * @param child the frame that is carried
   * @param parentFromChild the transform
   */
  public void fix(FrameId parent, FrameId child, RigidTransform parentFromChild) {
    buffer.putStatic(parent, child, parentFromChild, "test");
  }

  @Override
  public TransformLookup<FrameId> lookup(FrameId target, FrameId source, Optional<Stamp> stamp) {
    return stamp.map(at -> buffer.lookup(target, source, at.nanos())).orElseGet(() -> buffer.lookupLatest(target, source));
  }

  @Override
  public List<FrameId> all() {
    return buffer.frames().stream().sorted(Comparator.comparing(FrameId::robot).thenComparing(FrameId::name)).toList();
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return buffer.parentOf(frame);
  }
}

package org.robotui.testkit;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robotui.api.frame.FrameLink;
import org.robotui.api.frame.FrameRefusal;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformBuffer;
import org.robotui.geometry.TransformLimits;
import org.robotui.geometry.TransformLookup;

/** Frames that a test fixes. */
public final class FakeFrames implements Frames {
  private final TransformBuffer<FrameId> buffer =
      new TransformBuffer<>(new TransformLimits(10_000_000_000L, 10_000, 4000));
  private volatile Optional<List<FrameLink>> links = Optional.empty();
  private volatile List<FrameRefusal> refusals = List.of();

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
    return stamp.map(at -> buffer.lookup(target, source, at.nanos()))
        .orElseGet(() -> buffer.lookupLatest(target, source));
  }

  @Override
  public List<FrameId> all() {
    return buffer.frames().stream().sorted(Comparator.comparing(FrameId::robot).thenComparing(FrameId::name)).toList();
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return buffer.parentOf(frame);
  }

  /**
   * Says what is known of the transforms, in place of what was fixed.
   *
   * @param known the transforms
   * @param refused those that were not taken
   */
  public void known(List<FrameLink> known, List<FrameRefusal> refused) {
    links = Optional.of(List.copyOf(known));
    refusals = List.copyOf(refused);
  }

  @Override
  public List<FrameLink> links() {
    return links
        .orElseGet(() -> buffer.edges().stream().map(edge -> new FrameLink(edge.parent(), edge.child(), edge.isStatic(),
            Optional.empty(), 0, edge.samples(), edge.authority(), 0, 0, List.of())).toList());
  }

  @Override
  public List<FrameRefusal> refusals() {
    return refusals;
  }
}

package org.robotui.core.internal.life;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.frame.FrameSink;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;

/**
 * The transforms of one robot interface that hold for all times, to be said again when frames were forgotten. Safe for
 * all threads.
 */
final class FixedFrames {
  /** No robot has so many. */
  private static final int MOST = 10_000;

  private record Said(FrameTransform transform, String authority) {}

  private final Map<FrameId, Said> said = new LinkedHashMap<>();

  synchronized void remember(TransformSet transforms, String authority) {
    transforms.transforms().stream().filter(FrameTransform::fixed)
        .filter(t -> said.size() < MOST || said.containsKey(t.child()))
        .forEach(t -> said.put(t.child(), new Said(t, authority)));
  }

  void sayAgain(FrameSink frames) {
    copy().forEach(s -> frames.add(new TransformSet(List.of(s.transform())), s.authority()));
  }

  private synchronized List<Said> copy() {
    return List.copyOf(said.values());
  }
}

package org.robotui.data.geometry;

import java.util.List;
import java.util.stream.Stream;
import org.robotui.data.Conflation;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.Framed;
import org.robotui.data.Keyed;
import org.robotui.data.Late;
import org.robotui.data.internal.Merge;

/**
 * Transforms between frames, the newest per parent and child.
 *
 * @param transforms the transforms
 */
@Delivery(conflation = Conflation.KEYED, late = Late.ALL_KEYS)
public record TransformSet(List<FrameTransform> transforms) implements Keyed<TransformSet>, Framed {
  private record Edge(FrameId parent, FrameId child) {}

  /**
   * Copies the list.
   *
   * @param transforms the transforms
   */
  public TransformSet {
    transforms = List.copyOf(transforms);
  }

  @Override
  public Stream<FrameId> frames() {
    return transforms.stream().flatMap(transform -> Stream.of(transform.parent(), transform.child()))
        .filter(FrameId::isNamed);
  }

  @Override
  public TransformSet over(TransformSet older) {
    return new TransformSet(Merge.byKey(older.transforms, transforms, t -> new Edge(t.parent(), t.child())));
  }

  @Override
  public int keys() {
    return transforms.size();
  }

  @Override
  public TransformSet last(int most) {
    return new TransformSet(Merge.last(transforms, most));
  }
}

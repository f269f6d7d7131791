package org.robotui.data.marker;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.data.Conflation;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.Framed;
import org.robotui.data.Keyed;
import org.robotui.data.Late;
import org.robotui.data.internal.Merge;

/**
 * What became of the interactive markers of one source, the newest per name.
 *
 * @param all true where there are no markers but these: whatever came before is gone
 * @param entries what became of each marker
 */
@Delivery(conflation = Conflation.KEYED, late = Late.ALL_KEYS, expires = false)
public record InteractiveMarkerSet(boolean all, List<Entry> entries) implements Keyed<InteractiveMarkerSet>, Framed {
  /**
   * What became of a marker.
   *
   * @param name of the marker
   * @param marker how it is now, or none where it is gone
   */
  public record Entry(String name, Optional<InteractiveMarker> marker) {}

  /**
   * Copies the list.
   *
   * @param all whatever came before is gone
   * @param entries what became of each marker
   */
  public InteractiveMarkerSet {
    entries = List.copyOf(entries);
  }

  @Override
  public Stream<FrameId> frames() {
    return entries.stream().flatMap(entry -> entry.marker().stream()).map(InteractiveMarker::frame)
        .filter(FrameId::isNamed);
  }

  @Override
  public InteractiveMarkerSet over(InteractiveMarkerSet older) {
    return all ? this : new InteractiveMarkerSet(older.all, Merge.byKey(older.entries, entries, Entry::name));
  }

  @Override
  public int keys() {
    return entries.size();
  }

  @Override
  public InteractiveMarkerSet last(int most) {
    return new InteractiveMarkerSet(all, Merge.last(entries, most));
  }
}

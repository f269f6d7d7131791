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
 * What became of markers of one source, the newest per namespace and id. Merged values keep that a marker was taken
 * away, so that a consumer that knew it hears of it.
 *
 * @param all true where there are no markers but these: whatever came before is gone
 * @param entries what became of each marker
 */
@Delivery(conflation = Conflation.KEYED, late = Late.ALL_KEYS, expires = false)
public record MarkerSet(boolean all, List<Entry> entries) implements Keyed<MarkerSet>, Framed {
  private static final int MOST = 16_384;

  /**
   * What became of a marker.
   *
   * @param key its name
   * @param marker how it is now, or none where it was taken away
   */
  public record Entry(Marker.Key key, Optional<Marker> marker) {}

  /**
   * Copies the list.
   *
   * @param all whatever came before is gone
   * @param entries what became of each marker
   */
  public MarkerSet {
    entries = List.copyOf(entries);
  }

  @Override
  public Stream<FrameId> frames() {
    return entries.stream().flatMap(entry -> entry.marker().stream()).map(Marker::frame).filter(FrameId::isNamed);
  }

  @Override
  public MarkerSet over(MarkerSet older) {
    return all ? this : new MarkerSet(older.all, Merge.byKey(older.entries, entries, Entry::key));
  }

  @Override
  public int keys() {
    return entries.size();
  }

  @Override
  public int most() {
    return MOST;
  }

  @Override
  public MarkerSet last(int most) {
    return new MarkerSet(all, Merge.last(entries, most));
  }
}

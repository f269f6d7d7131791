package org.robotui.data.marker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class MarkerSetTest {
  private static MarkerSet.Entry added(int id) {
    return new MarkerSet.Entry(new Marker.Key("things", id), Optional.of(marker(id, Floats.EMPTY, Bytes.EMPTY)));
  }

  private static MarkerSet.Entry gone(int id) {
    return new MarkerSet.Entry(new Marker.Key("things", id), Optional.empty());
  }

  private static Marker marker(int id, Floats points, Bytes colors) {
    return new Marker(new Marker.Key("things", id), new FrameId("robby", "map"), Optional.empty(), 0, Marker.Type.CUBE,
        RigidTransform.IDENTITY, new Vector3(1, 1, 1), new Color(1, 1, 1, 1), 0, false, points, colors, "", "", false);
  }

  @Test
  void whatWasTakenAwayIsKeptForThoseWhoKnewIt() {
    MarkerSet merged =
        new MarkerSet(false, List.of(gone(1), added(3))).over(new MarkerSet(false, List.of(added(1), added(2))));
    assertEquals(List.of(gone(1), added(2), added(3)), merged.entries());
  }

  @Test
  void aSetThatIsAllThereIsReplacesWhatWasBefore() {
    MarkerSet all = new MarkerSet(true, List.of(added(2)));
    assertEquals(all, all.over(new MarkerSet(false, List.of(added(1)))));
    assertTrue(new MarkerSet(false, List.of(added(3))).over(all).all(), "what came before both is still gone");
  }

  @Test
  void manyMarkersAreHeldBeforeSomeAreGivenUp() {
    assertTrue(new MarkerSet(false, List.of()).most() >= 10_000);
    assertEquals(List.of(added(2)), new MarkerSet(false, List.of(added(1), added(2))).last(1).entries());
  }

  @Test
  void numbersThatAreNoPointsAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> marker(1, Floats.of(1, 2), Bytes.EMPTY));
    assertThrows(IllegalArgumentException.class, () -> marker(1, Floats.of(1, 2, 3), Bytes.of((byte) 1)));
  }
}

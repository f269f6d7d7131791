package org.robotui.uic.scene3d.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Pick;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Shape;

class PicksTest {
  private static final Shape LINK = line();
  private final Picks picks = new Picks();

  private static Shape line() {
    return LineSet.of(LineSet.Kind.STRIP, 1, 0, 0, 0, 1, 0, 0);
  }

  private static Part part(Shape shape, double x) {
    RigidTransform at = new RigidTransform(new Vector3(x, 0, 0), Quaternion.IDENTITY);
    return new Part("link", shape, at, Material.flat(Rgba.WHITE),
        (element, place) -> Properties.of("link", new Properties.Entry("x", Double.toString(x)),
            new Properties.Entry("element", "" + element)));
  }

  private static Stage stage(Part... parts) {
    return new Stage(1, Map.of("robot", List.of(parts)), List.of(), Optional.empty(), List.of(), List.of(), 0);
  }

  @Test
  void theSelectionGoesAlongWithWhatMoves() {
    picks.select(Optional.of(Picks.of(new Pick("robot", part(LINK, 2), 1, new Vector3(2.5, 0, 0)))));
    assertFalse(picks.keep(stage(part(LINK, 2))), "nothing else is to be said");
    assertTrue(picks.keep(stage(part(LINK, 7))));
    Selection now = picks.selection().orElseThrow();
    assertEquals(new Vector3(7.5, 0, 0), now.place());
    assertEquals("7.0", now.properties().entries().getFirst().value());
    assertEquals("1", now.properties().entries().getLast().value());
    assertEquals(7, now.part().bounds().orElseThrow().low().x());
  }

  @Test
  void ofAnotherShapeItStaysWhatWasPointedAt() {
    Selection before = Picks.of(new Pick("robot", part(LINK, 2), 1, new Vector3(2.5, 0, 0)));
    picks.select(Optional.of(before));
    assertFalse(picks.keep(stage(part(line(), 7))));
    assertEquals(Optional.of(before), picks.selection());
  }

  @Test
  void whatIsNoMoreIsForgotten() {
    picks.select(Optional.of(Picks.of(new Pick("robot", part(LINK, 2), 1, Vector3.ZERO))));
    assertTrue(picks.keep(stage()));
    assertEquals(Optional.empty(), picks.selection());
  }
}

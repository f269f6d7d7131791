package org.robotui.gl.internal.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.robotui.gl.internal.scene.Stage.flat;
import static org.robotui.gl.internal.scene.Stage.part;
import static org.robotui.gl.internal.scene.Stage.points;
import static org.robotui.gl.internal.scene.Stage.request;
import static org.robotui.gl.internal.scene.Stage.square;

import java.nio.FloatBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.render.Eye.Projection.Perspective;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;

/** What is found under the pointer: part, element and place. */
@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+", disabledReason = "no display: DISPLAY is not set")
class PickTest {
  private static final int RED = 0xff0000;

  private final Stage stage = new Stage();

  @AfterEach
  void close() throws InterruptedException {
    stage.close();
  }

  private Pick hit(RenderRequest request, int x, int y) throws Exception {
    return stage.pick(request, x, y).orElseThrow(() -> new AssertionError("nothing at " + x + ", " + y));
  }

  private static void assertNear(Vector3 expected, Vector3 actual, double metres) {
    assertEquals(0, expected.minus(actual).norm(), metres, () -> "expected near " + expected + ", was " + actual);
  }

  @Test
  void aPointIsFoundWithinSomePixels() throws Exception {
    RenderRequest request = request(flat("p", points(1, 0, 0.3f, 0, 0.5f, -0.195f, 0.295f, 0, 0, -0.4f), RED));
    Pick pick = hit(request, 72, 18);
    assertEquals(1, pick.element());
    assertEquals("p", pick.part().key());
    assertEquals("display", pick.display());
    assertNear(new Vector3(0.5, -0.195, 0.295), pick.place(), 0.012);
    assertEquals(Optional.empty(), stage.pick(request, 50, 50));
  }

  @Test
  void theNearestPointOfManyIsFound() throws Exception {
    float[] xyz = new float[3 * 20 * 20];
    for (int i = 0; i < 400; i++) {
      xyz[3 * i + 1] = 0.475f - i % 20 * 0.05f;
      xyz[3 * i + 2] = 0.475f - i / 20 * 0.05f;
    }
    RenderRequest request = request(flat("p", points(1, xyz), RED));
    assertEquals(7 * 20 + 11, hit(request, 57, 37).element());
  }

  @Test
  void segmentsTrianglesAndInstancesAreFound() throws Exception {
    Part line = flat("l", LineSet.of(LineSet.Kind.STRIP, 1, 0, 0.4f, 0.4f, 0, 0, 0.4f, 0, -0.4f, 0.4f), RED);
    assertEquals(1, hit(request(line), 70, 10).element());
    Part mesh = flat("m", square(0.5f, 0.4f), RED);
    assertEquals(1, hit(request(mesh), 20, 20).element());
    assertEquals(0, hit(request(mesh), 80, 80).element());
    assertNear(new Vector3(0.5, 0.295, 0.295), hit(request(mesh), 20, 20).place(), 1e-3);
    float[] placings = {0, 0.3f, 0, 0, 0, 0, 1, 1, 1, 1, 0, -0.3f, 0, 0, 0, 0, 1, 1, 1, 1};
    Part many = flat("i", Instances.of(square(0, 0.05f), FloatBuffer.wrap(placings), Optional.empty()), RED);
    assertEquals(1, hit(request(many), 80, 50).element());
    assertEquals(0, hit(request(many), 20, 50).element());
  }

  @Test
  void whatIsOnTopIsFoundFirst() throws Exception {
    Part top = part("top", square(1, 0.2f), Material.flat(Rgba.of(RED)).onTop());
    Pick pick = hit(request(flat("near", square(0, 0.4f), RED), top), 50, 50);
    assertEquals("top", pick.part().key());
    assertEquals(1, pick.place().x(), 1e-3);
  }

  @Test
  void placesAreRightInPerspective() throws Exception {
    RenderRequest flatRequest = request(flat("m", square(2, 3), RED));
    Eye eye = new Eye(flatRequest.eye().fixedFromEye(), new Perspective(Math.PI / 2), 0.1, 100);
    RenderRequest request =
        new RenderRequest(Map.of("d", flatRequest.parts().get("display")), eye, 200, 100, 1, Rgba.of(0), 9, List.of());
    Vector3 place = hit(request, 120, 30).place();
    assertNear(new Vector3(2, -7 * 20.5 / 50, 7 * 19.5 / 50), place, 0.01);
  }
}

package org.robotui.gl.internal.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.robotui.gl.internal.scene.Stage.flat;
import static org.robotui.gl.internal.scene.Stage.part;
import static org.robotui.gl.internal.scene.Stage.request;
import static org.robotui.gl.internal.scene.Stage.square;

import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.Ledger;
import org.robotui.gl.internal.gpu.Ledger.Kind;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Renderer;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;

/** No object of OpenGL is left behind: by what we count, and by what OpenGL itself says of the names of objects. */
@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+", disabledReason = "no display: DISPLAY is not set")
class LeakTest {
  private static final int RED = 0xff0000;
  private static final int TIMES = 200;
  private static final int LOSSES = 10;
  /** Names are given from 1 on, and the lowest that is free: so many cannot be in use at once. */
  private static final int MOST_NAMES = 40 * TIMES;

  private final Stage stage = new Stage();

  @AfterEach
  void close() throws InterruptedException {
    stage.close();
  }

  /** One of each shape, those of points also in the form that OpenGL draws where it is software. */
  private static Part[] parts() {
    Texture texture = new Texture(2, 2, ByteBuffer.allocate(16), true);
    return new Part[]{
        flat("points", Stage.points(2, 0, 0, 0), RED), flat("discs", discs(), RED),
        part("translucent points", Stage.points(2, 0, 0, 0), Material.flat(new Rgba(1, 0, 0, 0.5f))),
        flat("lines", LineSet.of(LineSet.Kind.STRIP, 1, new float[6]), RED),
        part("mesh", square(0, 0.1f), Material.picture(texture, 1)),
        flat("label", new Label("word", 9, Unit.PIXELS), RED),
        flat("instances",
            Instances.of(square(0, 0.1f), FloatBuffer.wrap(new float[10]), Optional.of(ByteBuffer.wrap(new byte[4]))),
            RED)};
  }

  private static PointSet discs() {
    PointSet squares = Stage.points(2, 0, 0, 0);
    return new PointSet(squares.xyz(), squares.rgba(), 2, Unit.METRES, PointSet.Style.DISC, squares.bounds(),
        Optional.empty());
  }

  @Test
  void nothingIsLeftOfManyScenes() throws Exception {
    stage.picture(request());
    Map<Kind, Integer> counted = counted();
    Map<Kind, Integer> named = named();
    long bytes = bytes();
    for (int i = 0; i < TIMES; i++) {
      Renderer renderer = stage.open();
      RenderRequest request = request(parts());
      assertInstanceOf(Rendered.Picture.class,
          renderer.render(request).toCompletableFuture().get(60, TimeUnit.SECONDS));
      renderer.pick(request, 50, 50).toCompletableFuture().get(60, TimeUnit.SECONDS);
      renderer.close();
    }
    assertEquals(counted, counted());
    assertEquals(bytes, bytes());
    assertEquals(named, named());
  }

  @Test
  void aPartThatIsTakenAwayLeavesNothing() throws Exception {
    stage.picture(request(parts()));
    stage.picture(request());
    Map<Kind, Integer> empty = counted();
    Map<Kind, Integer> emptyNamed = named();
    for (Part part : parts()) {
      for (int i = 0; i < TIMES; i++) {
        stage.picture(request(parts()[index(part)]));
        stage.picture(request());
      }
      assertEquals(empty, counted(), () -> "after " + part.key());
      assertEquals(emptyNamed, named(), () -> "after " + part.key());
    }
  }

  private static int index(Part part) {
    return Arrays.stream(parts()).map(Part::key).toList().indexOf(part.key());
  }

  @Test
  void partsThatComeAndGoBesideOthersLeaveTheSame() throws Exception {
    Part[] all = parts();
    stage.pick(request(all), 50, 50);
    stage.picture(request(all));
    Map<Kind, Integer> full = counted();
    for (int i = 0; i < TIMES; i++) {
      int without = i % all.length;
      stage.picture(
          request(IntStream.range(0, all.length).filter(k -> k != without).mapToObj(k -> all[k]).toArray(Part[]::new)));
      stage.pick(request(parts()), 50, 50);
      stage.picture(request(parts()));
    }
    assertEquals(full, counted());
  }

  @Test
  void aLostContextTakesItsObjectsAlongAndTheNextHasNoMore() throws Exception {
    int[] picture = stage.picture(request(parts())).rgb();
    Map<Kind, Integer> full = counted();
    Map<Kind, Integer> fullNamed = named();
    for (int i = 0; i < LOSSES; i++) {
      Renderer other = stage.open();
      other.render(request(parts())).toCompletableFuture().get(60, TimeUnit.SECONDS);
      assertNotEquals(full, counted());
      stage.there(() -> {
        stage.thread().dropContext();
        return true;
      });
      assertArrayEquals(picture, stage.picture(request(parts())).rgb());
      other.close(); // Its objects are gone already, and others have their names now.
      assertEquals(full, counted());
      assertEquals(fullNamed, named());
      assertArrayEquals(picture, stage.picture(request(parts())).rgb());
    }
  }

  private Gpu gpu() {
    return stage.thread().present().orElseThrow();
  }

  private long bytes() throws Exception {
    return stage.there(() -> gpu().ledger().bytes());
  }

  /** What we say is held. */
  private Map<Kind, Integer> counted() throws Exception {
    return stage.there(() -> {
      Ledger ledger = gpu().ledger();
      Map<Kind, Integer> counts = new EnumMap<>(Kind.class);
      List.of(Kind.values())
          .forEach(kind -> counts.computeIfAbsent(kind, k -> ledger.held(k) == 0 ? null : ledger.held(k)));
      return counts;
    });
  }

  /** What OpenGL says is held, its own objects among them: its picture of 16 x 16 is one. */
  private Map<Kind, Integer> named() throws Exception {
    return stage.there(() -> {
      gpu().gl().glUseProgram(0); // One that is in use is deleted only when another is.
      Map<Kind, Integer> counts = new EnumMap<>(Kind.class);
      for (Kind kind : Kind.values()) {
        counts.put(kind,
            (int) IntStream.rangeClosed(1, MOST_NAMES).filter(name -> isOne(gpu().gl(), kind, name)).count());
      }
      return counts;
    });
  }

  private static boolean isOne(GL3 gl, Kind kind, int name) {
    return switch (kind) {
      case BUFFER -> gl.glIsBuffer(name);
      case VERTEX_ARRAY -> gl.glIsVertexArray(name);
      case TEXTURE -> gl.glIsTexture(name);
      case FRAMEBUFFER -> gl.glIsFramebuffer(name);
      case RENDERBUFFER -> gl.glIsRenderbuffer(name);
      case PROGRAM -> gl.glIsProgram(name);
    };
  }
}

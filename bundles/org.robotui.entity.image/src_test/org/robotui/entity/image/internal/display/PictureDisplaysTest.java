package org.robotui.entity.image.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;

class PictureDisplaysTest implements Places, DisplayContext {
  private static final FrameId OPTICAL = new FrameId("Keira", "optical");
  /** x of the picture to the right, y down, z forward: seen from behind the camera, in a frame with x forward. */
  private static final RigidTransform LOOKING =
      new RigidTransform(Vector3.ZERO, Quaternion.fromRollPitchYaw(-Math.PI / 2, 0, -Math.PI / 2));

  private final Map<String, Object> values = new HashMap<>();
  private final Deque<Runnable> tasks = new ArrayDeque<>();
  private int woken;

  private DisplayResult update(Display display, Schema schema, Data... arrived) {
    schema.settings().forEach(s -> s.fallback().ifPresent(f -> values.putIfAbsent(s.name(), f)));
    List<Envelope<? extends Data>> envelopes = Arrays.stream(arrived).<Envelope<? extends Data>>map(
        v -> new Envelope<>(v, new SourceId("base", "image"), 1, Optional.empty(), 0, Optional.empty())).toList();
    return display.update(new DisplayTick(envelopes, new InputState.Live(10, 0), this, new Settings(schema, values),
        Rgba.WHITE, 0, false));
  }

  private void work() {
    while (!tasks.isEmpty()) {
      tasks.pop().run();
    }
  }

  /** Red above, blue below, with a green corner at the upper left. */
  private static RawImage picture(FrameId frame, int width, int height) {
    byte[] rgb = new byte[3 * width * height];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int part = x < width / 4 && y < height / 4 ? 1 : y < height / 2 ? 0 : 2;
        rgb[3 * (y * width + x) + part] = (byte) 220;
      }
    }
    return new RawImage(frame, width, height, PixelEncoding.RGB8, false, 3 * width, Bytes.of(rgb));
  }

  private static CameraInfo info(double focal) {
    return new CameraInfo(OPTICAL, 64, 48, "plumb_bob", Doubles.EMPTY, Doubles.of(focal, 0, 32, 0, focal, 24, 0, 0, 1),
        Doubles.of(1, 0, 0, 0, 1, 0, 0, 0, 1), Doubles.of(focal, 0, 32, 0, 0, focal, 24, 0, 0, 0, 1, 0));
  }

  private static Texture texture(DisplayResult result) {
    return result.parts().getLast().material().texture().orElseThrow();
  }

  @Test
  void aPictureIsDecodedInTheBackgroundAndStandsBeforeItsFrame() {
    ImageDisplay display = new ImageDisplay(this);
    assertInstanceOf(DisplayStatus.NoData.class, update(display, ImageType.SCHEMA, picture(OPTICAL, 64, 48)).status());
    assertEquals(1, tasks.size());
    work();
    assertEquals(1, woken);
    DisplayResult result = update(display, ImageType.SCHEMA);
    assertEquals(new DisplayStatus.Shown("64 x 48 rgb8"), result.status());
    Box3 box = result.parts().getFirst().bounds().orElseThrow();
    assertEquals(1, box.center().x(), 1e-6, "a metre ahead");
    assertEquals(0.375, box.high().z(), 1e-6, "as high as 48 of 64");
    assertEquals(0.5, box.high().y(), 1e-6);
    assertEquals(0x00dc00ff, texture(result).rgba().getInt(0), "the upper left corner");
    DisplayResult again = update(display, ImageType.SCHEMA);
    assertSame(result.parts().getFirst().shape(), again.parts().getFirst().shape());
    assertSame(texture(result), texture(again));
    display.close();
  }

  @Test
  void ofManyPicturesOnlyTheNewestIsDecodedAndALargeOneIsShrunk() {
    ImageDisplay display = new ImageDisplay(this);
    values.put(PictureSettings.PIXELS, 32L);
    for (int i = 1; i <= 20; i++) {
      update(display, ImageType.SCHEMA, picture(OPTICAL, 64 * i, 48));
    }
    assertEquals(1, tasks.size());
    work();
    assertEquals(1, woken);
    assertTrue(texture(update(display, ImageType.SCHEMA)).width() <= 32);
    display.close();
    assertEquals(0, tasks.size());
    update(display, ImageType.SCHEMA, picture(OPTICAL, 64, 48));
    assertEquals(0, tasks.size(), "closed");
  }

  @Test
  void whatCannotBeDecodedIsSaid() {
    try (ImageDisplay display = new ImageDisplay(this)) {
      update(display, ImageType.SCHEMA, new CompressedImage(OPTICAL, "jpeg", Bytes.of((byte) 1, (byte) 2, (byte) 3)));
      work();
      assertInstanceOf(DisplayStatus.Unfit.class, update(display, ImageType.SCHEMA).status());
    }
  }

  @Test
  void theBaseOfThePyramidIsAsWideAsTheCameraSees() {
    try (CameraDisplay display = new CameraDisplay(this)) {
      assertInstanceOf(DisplayStatus.Partly.class, update(display, CameraType.SCHEMA, info(64)).status());
      update(display, CameraType.SCHEMA, picture(new FrameId("Keira", "other"), 64, 48));
      assertEquals(0, tasks.size(), "a picture of another camera");
      update(display, CameraType.SCHEMA, picture(OPTICAL, 64, 48));
      work();
      DisplayResult result = update(display, CameraType.SCHEMA);
      assertEquals(List.of("edges", "picture"), result.parts().stream().map(Part::key).toList());
      Box3 box = result.parts().getLast().bounds().orElseThrow();
      assertEquals(0.5, box.high().y(), 1e-6);
      assertEquals(0.375, box.high().z(), 1e-6);
      assertTrue(
          result.parts().getFirst().describer().describe(0, Vector3.ZERO).entries().toString().contains("53.1\u00b0"));
    }
  }

  @Test
  void aCameraWithoutCalibrationIsSaid() {
    try (CameraDisplay display = new CameraDisplay(this)) {
      assertInstanceOf(DisplayStatus.Unfit.class, update(display, CameraType.SCHEMA, info(0)).status());
      assertInstanceOf(DisplayStatus.Unfit.class, update(display, CameraType.SCHEMA, info(Double.NaN)).status());
      assertInstanceOf(DisplayStatus.Unfit.class, update(display, CameraType.SCHEMA, info(1e-300)).status());
    }
  }

  @Test
  @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
  void looksAsItDid() {
    try (CameraDisplay display = new CameraDisplay(this); ScenePictures pictures = new ScenePictures()) {
      update(display, CameraType.SCHEMA, info(64), picture(OPTICAL, 64, 48));
      work();
      pictures.assertLike(PictureDisplaysTest.class, "camera",
          ScenePictures.request(update(display, CameraType.SCHEMA).parts(),
              ScenePictures.eye(new Vector3(-0.7, 0.6, 0.6), new Vector3(0.7, 0, 0))));
    }
  }

  @Test
  @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
  void aPictureInSpaceLooksAsItDid() {
    try (ImageDisplay display = new ImageDisplay(this); ScenePictures pictures = new ScenePictures()) {
      update(display, ImageType.SCHEMA, picture(OPTICAL, 64, 48));
      work();
      pictures.assertLike(PictureDisplaysTest.class, "image",
          ScenePictures.request(ScenePictures.withAxes(update(display, ImageType.SCHEMA).parts(), 0.4),
              ScenePictures.eye(new Vector3(-0.7, 0.6, 0.6), new Vector3(0.7, 0, 0))));
    }
  }

  @Override
  public Executor background() {
    return tasks::add;
  }

  @Override
  public void wake() {
    woken++;
  }

  @Override
  public CommandOutcome send(Data command) {
    throw new AssertionError("nothing is sent");
  }

  @Override
  public FrameId fixed() {
    return new FrameId("Keira", "map");
  }

  @Override
  public Place at(FrameId frame, Optional<Stamp> stamp) {
    return new Place.At(LOOKING);
  }

  @Override
  public List<FrameId> all() {
    return List.of(OPTICAL);
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return Optional.empty();
  }
}

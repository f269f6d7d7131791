package org.robotui.uic.camera.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.Arity;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.data.Bytes;
import org.robotui.data.CompressedImage;
import org.robotui.data.FrameId;
import org.robotui.data.Image;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.PictureDecoder;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.Pictures;

class CameraUicTest {
  private static final SourceId PORT = new SourceId("camera", "image");

  private final FakeUicContext context = new FakeUicContext("camera", new CameraType().schema());
  private final FakeInput<Image> input = context.input(CameraType.IMAGE);
  private final CameraModel model =
      new CameraModel(input, context.input(CameraType.CAMERA_INFO), context.ruic(), PORT);

  @Test
  void aPictureIsDecodedOnceAndNamed() {
    input.put(Pictures.room(32, 24));
    Shot first = model.look();
    assertEquals("32\u00d724 rgb8 10.0\u00a0Hz", first.note());
    assertTrue(first.seen().orElseThrow() == model.look().seen().orElseThrow());
  }

  @Test
  void tickSaysWhetherThereIsSomethingNew() {
    CameraUic uic = new CameraUic(context);
    uic.tick(0);
    assertFalse(uic.tick(1));
    input.put(Pictures.room(32, 24));
    assertTrue(uic.tick(2));
    assertFalse(uic.tick(3));
    input.state(new InputState.Stale(2.1, "the link is lost"));
    assertTrue(uic.tick(4));
  }

  @Test
  void aStalePictureSaysItsAge() {
    input.put(Pictures.room(32, 24));
    model.look();
    input.state(new InputState.Stale(2.1, "the link is lost"));
    assertEquals("32\u00d724 rgb8 stale 2.1\u00a0s", model.look().note());
  }

  @Test
  void aBrokenPictureIsAFailureThatNamesItsSource() {
    input.put(new CompressedImage(new FrameId("Keira", "camera"), "jpeg", Bytes.of(new byte[3])));
    Shot shot = model.look();
    assertInstanceOf(InputState.Failed.class, shot.state());
    assertEquals("base.data: the picture (format 'jpeg', 3 bytes) is neither JPEG nor PNG", shot.state().explanation());
    assertEquals(Optional.empty(), shot.seen());
    input.put(Pictures.room(8, 8));
    assertInstanceOf(InputState.Live.class, model.look().state());
  }

  @Test
  void severalCamerasAreOfferedForChoice() {
    List<SourceId> both = List.of(new SourceId("ros", "/left/image_raw"), new SourceId("ros", "/right/image_raw"));
    match(MatchState.AMBIGUOUS, both);
    assertEquals(both, model.look().candidates());
    match(MatchState.REFUSED, List.of());
    assertEquals(List.of(), model.look().candidates());
  }

  @Test
  void aPictureIsSavedByTheTick(@TempDir Path folder) throws IOException {
    Decoding.Decoded room = (Decoding.Decoded) PictureDecoder.decode(Pictures.room(8, 6));
    Path file = folder.resolve("room.png");
    Saver saver = new Saver();
    saver.save(room.picture(), file.toString());
    assertEquals(Optional.of("saved " + file), saver.tick(0));
    Decoding again = PictureDecoder.decode(
        new CompressedImage(new FrameId("Keira", "camera"), "png", Bytes.of(Files.readAllBytes(file))));
    assertEquals(room.picture().values().at(7, 5), assertInstanceOf(Decoding.Decoded.class, again).picture().values().at(7, 5));
    assertEquals(Optional.empty(), saver.tick(5_000_000_000L));
    saver.save(room.picture(), folder.resolve("none/room.png").toString());
    assertTrue(saver.tick(6_000_000_000L).orElseThrow().startsWith("cannot save "));
  }

  private void match(MatchState state, List<SourceId> candidates) {
    RuicSnapshot now = context.ruic().snapshot();
    Match match = new Match(PORT, PortKind.STREAM, "Image", Arity.ONE, state, List.of(), candidates, "two pictures fit");
    context.ruic().snapshot(
        new RuicSnapshot(now.name(), now.state(), now.reason(), now.link(), now.components(), now.ports(), List.of(match)));
  }
}

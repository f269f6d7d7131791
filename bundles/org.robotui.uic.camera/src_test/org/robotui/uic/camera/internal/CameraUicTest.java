package org.robotui.uic.camera.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
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
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.ColorMap;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.PictureDecoder;
import org.robotui.entity.image.Rendering;
import org.robotui.entity.image.Span;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.Pictures;

class CameraUicTest {
  private static final SourceId PORT = new SourceId("camera", "image");

  private final FakeUicContext context = new FakeUicContext("camera", new CameraType().schema());
  private final FakeInput<Image> input = context.input(CameraType.IMAGE);
  private final CameraModel model =
      new CameraModel(input, context.input(CameraType.CAMERA_INFO), context.ruic(), PORT);

  private Shot look() {
    return model.look(Rendering.USUAL, 1);
  }

  @Test
  void aPictureIsDecodedOnceAndNamed() {
    input.put(Pictures.room(32, 24));
    Shot first = look();
    assertEquals("32\u00d724 rgb8 10.0\u00a0Hz", first.note());
    assertSame(first.seen().orElseThrow(), look().seen().orElseThrow());
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
    look();
    input.state(new InputState.Stale(2.1, "the link is lost"));
    assertEquals("32\u00d724 rgb8 stale 2.1\u00a0s", look().note());
  }

  @Test
  void aBrokenPictureIsAFailureThatNamesItsSource() {
    input.put(new CompressedImage(new FrameId("Keira", "camera"), "jpeg", Bytes.of(new byte[3])));
    Shot shot = look();
    assertInstanceOf(InputState.Failed.class, shot.state());
    assertEquals("base.data: the picture (format 'jpeg', 3 bytes) cannot be decoded: it is neither JPEG nor PNG",
        shot.state().explanation());
    assertEquals(Optional.empty(), shot.shown());
    input.put(Pictures.room(8, 8));
    assertInstanceOf(InputState.Live.class, look().state());
  }

  @Test
  void severalCamerasAreOfferedForChoice() {
    List<SourceId> both = List.of(new SourceId("ros", "/left/image_raw"), new SourceId("ros", "/right/image_raw"));
    match(MatchState.AMBIGUOUS, both);
    assertEquals(both, look().candidates());
    match(MatchState.REFUSED, List.of());
    assertEquals(List.of(), look().candidates());
  }

  @Test
  void otherColoursShowInTheSamePicture() {
    input.put(depth());
    Shot usual = look();
    Rendering grey = new Rendering(Optional.of(ColorMap.GREY), false, Optional.empty(), true);
    Shot chosen = model.look(grey, 1);
    assertTrue(chosen.differs(usual));
    assertEquals(ColorMap.GREY, chosen.shown().orElseThrow().picture().legend().orElseThrow().map());
  }

  @Test
  void aPictureSeenFromAfarIsMadeSmallByTheTick() {
    input.put(Pictures.room(32, 24));
    assertEquals(32, look().shown().orElseThrow().pixels().width);
    Shot small = model.look(Rendering.USUAL, 2);
    assertEquals(16, small.shown().orElseThrow().pixels().width);
    assertEquals(32, small.shown().orElseThrow().picture().width());
  }

  @Test
  void whatWasChosenIsKept() {
    CameraChoices choices = new CameraChoices(context.settings());
    choices.range(Optional.of(new Span(0.5, 4)));
    choices.nextMap(ColorMap.TURBO);
    choices.zoom(ZoomMode.ACTUAL);
    choices.toggle(CameraOptions.DETAILS);
    CameraOptions options = CameraOptions.of(context.settings().current());
    assertEquals(new Rendering(Optional.of(ColorMap.VIRIDIS), false, Optional.of(new Span(0.5, 4)), true),
        options.rendering());
    assertEquals(ZoomMode.ACTUAL, options.zoom());
    assertTrue(options.details());
    choices.range(Optional.empty());
    assertEquals(Optional.empty(), choices.options().rendering().range());
  }

  @Test
  void aRangeThatIsNoneFollowsThePicture() {
    context.settings().set(CameraOptions.RANGE, CameraOptions.FIXED);
    context.settings().set(CameraOptions.RANGE_MIN, 20.0);
    assertEquals(Optional.empty(), CameraOptions.of(context.settings().current()).rendering().range());
  }

  @Test
  void aPictureIsSavedInTheBackground(@TempDir Path folder) throws IOException {
    Picture room = decoded(Pictures.room(8, 6));
    Path file = folder.resolve("room.png");
    Saver saver = new Saver(Runnable::run);
    saver.save(room, Saver.Part.COLORS, file.toString());
    assertEquals(Optional.of("saved " + file), saver.tick(0));
    Picture again =
        decoded(new CompressedImage(new FrameId("Keira", "camera"), "png", Bytes.of(Files.readAllBytes(file))));
    assertEquals(room.values().at(7, 5), again.values().at(7, 5));
    assertEquals(Optional.empty(), saver.tick(5_000_000_000L));
    saver.save(room, Saver.Part.COLORS, folder.resolve("none/room.png").toString());
    assertTrue(saver.tick(6_000_000_000L).orElseThrow().startsWith("cannot save "));
    saver.save(room, Saver.Part.NUMBERS, file.toString());
    assertTrue(saver.tick(7_000_000_000L).orElseThrow().endsWith("no numbers of 16 bits"));
  }

  private static Picture decoded(Image image) {
    return assertInstanceOf(Decoding.Decoded.class, new PictureDecoder().decode(image, Rendering.USUAL)).picture();
  }

  private static RawImage depth() {
    return Pictures.raw(PixelEncoding.U16C1, 2, 1, new byte[]{1, 4, 0, 8});
  }

  private void match(MatchState state, List<SourceId> candidates) {
    RuicSnapshot now = context.ruic().snapshot();
    Match match =
        new Match(PORT, PortKind.STREAM, "Image", Arity.ONE, state, List.of(), candidates, "two pictures fit");
    context.ruic().snapshot(
        new RuicSnapshot(now.name(), now.state(), now.reason(), now.link(), now.components(), now.ports(),
            List.of(match)));
  }
}

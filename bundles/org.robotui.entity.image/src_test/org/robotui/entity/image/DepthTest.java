package org.robotui.entity.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.eclipse.swt.graphics.RGB;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.testkit.Pictures;

class DepthTest {
  private static final FrameId FRAME = new FrameId("Keira", "depth");

  private final PictureDecoder decoder = new PictureDecoder();

  @Test
  void metresAreColouredFromOneEndOfTheRangeToTheOther() {
    Picture picture = decoded(floats(1, 2, 3, Float.NaN, Float.POSITIVE_INFINITY, 0, -1), fixed(1, 3));
    assertEquals(rgb(ColorMap.TURBO.rgb(0)), picture.color(0, 0));
    assertEquals(rgb(ColorMap.TURBO.rgb(0.5)), near(picture.color(1, 0), ColorMap.TURBO.rgb(0.5)));
    assertEquals(rgb(ColorMap.TURBO.rgb(1)), picture.color(2, 0));
    for (int x = 3; x < 7; x++) {
      assertEquals(rgb(ColorMap.TURBO.nothing()), picture.color(x, 0), "pixel " + x + " was not measured");
    }
    assertEquals("3.000\u00a0m", picture.values().at(2, 0));
    assertEquals("NaN = no depth", picture.values().at(3, 0));
    assertEquals(Optional.of(new Legend(ColorMap.TURBO, false, new Span(1, 3), false, true, "m")), picture.legend());
  }

  @Test
  void millimetresAreShownInMetres() {
    Picture picture = decoded(shorts(PixelEncoding.U16C1, 0, 1000, 3000), fixed(1, 3));
    assertEquals(rgb(ColorMap.TURBO.nothing()), picture.color(0, 0));
    assertEquals(rgb(ColorMap.TURBO.rgb(0)), picture.color(1, 0));
    assertEquals(rgb(ColorMap.TURBO.rgb(1)), picture.color(2, 0));
    assertEquals("1000 = 1.000\u00a0m", picture.values().at(1, 0));
  }

  @Test
  void whatIsNoDepthIsShownAsPlainNumbers() {
    Rendering plain = new Rendering(Optional.of(ColorMap.VIRIDIS), true, Optional.of(new Span(0, 100)), false);
    Picture picture = decoded(shorts(PixelEncoding.U16C1, 0, 100), plain);
    assertEquals(rgb(ColorMap.VIRIDIS.rgb(1)), picture.color(0, 0), "reversed, and 0 is a number");
    assertEquals("100", picture.values().at(1, 0));
    assertEquals("", picture.legend().orElseThrow().unit());
  }

  @Test
  void brightnessIsGreyUnlessChosenOtherwise() {
    RawImage mono = shorts(PixelEncoding.MONO16, 0, 1000);
    assertEquals(ColorMap.GREY, decoded(mono, Rendering.USUAL).legend().orElseThrow().map());
    Rendering chosen = new Rendering(Optional.of(ColorMap.TURBO), false, Optional.empty(), true);
    assertEquals(ColorMap.TURBO, decoded(mono, chosen).legend().orElseThrow().map());
  }

  @Test
  void theRangeLeavesOutliersAsideWidensAtOnceAndNarrowsSlowly() {
    float[] wall = new float[1000];
    for (int i = 0; i < wall.length; i++) {
      wall[i] = 2 + i * 0.002f;
    }
    wall[500] = 900;
    Span first = span(wall);
    assertEquals(2, first.low(), 0.25);
    assertEquals(4, first.high(), 0.25);
    for (int i = 0; i < wall.length; i++) {
      wall[i] = 1 + i * 0.007f;
    }
    Span wide = span(wall);
    assertTrue(wide.low() < 1.2 && wide.high() > 7.8, wide.toString());
    for (int i = 0; i < wall.length; i++) {
      wall[i] = 2 + i * 0.002f;
    }
    Span next = span(wall);
    assertTrue(next.high() > 7, "it narrows slowly: " + next);
    for (int i = 0; i < 200; i++) {
      next = span(wall);
    }
    assertEquals(4, next.high(), 0.3, "but it does");
    assertEquals(next, span(new float[]{Float.NaN, 0}), "a picture without depth changes nothing");
  }

  @Test
  void anEvenPictureHasARangeToo() {
    Span span = span(new float[]{2, 2, 2});
    assertTrue(span.low() < 2 && span.high() > 2, span.toString());
    assertEquals(new Span(0, 1),
        new PictureDecoder().decode(floats(Float.NaN), Rendering.USUAL) instanceof Decoding.Decoded d
            ? d.picture().legend().orElseThrow().span()
            : null);
  }

  @Test
  void vectorsOfTwoShowTheirLength() {
    ByteBuffer bytes = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putFloat(3).putFloat(4).putFloat(0).putFloat(0);
    Picture picture = decoded(Pictures.raw(PixelEncoding.F32C2, 2, 1, bytes.array()), fixed(0, 5));
    assertEquals(rgb(ColorMap.TURBO.rgb(1)), picture.color(0, 0));
    assertEquals(rgb(ColorMap.TURBO.rgb(0)), picture.color(1, 0));
  }

  @Test
  void compressedDepthIsDecodedBehindItsHeader() throws IOException {
    Picture picture =
        decoded(new CompressedImage(FRAME, "16UC1; compressedDepth png", depthPng(0, 0, 0, 1500)), Rendering.USUAL);
    assertEquals("1500 = 1.500\u00a0m", picture.values().at(1, 0));
    assertEquals("0 = no depth", picture.values().at(0, 0));
    assertEquals("16UC1 png", picture.encoding());
  }

  @Test
  void quantisedDepthIsMetresAgain() throws IOException {
    // a / (number - b) with a = 1000 and b = -100: 400 is 2 m.
    Picture picture = decoded(new CompressedImage(FRAME, "32FC1; compressedDepth png", depthPng(1000, -100, 0, 400)),
        Rendering.USUAL);
    assertEquals("2.000\u00a0m", picture.values().at(1, 0));
    assertEquals("NaN = no depth", picture.values().at(0, 0));
  }

  @Test
  void rvlIsDecoded() {
    // Two zeros, then three numbers: +1000, -10, +0: folded 2000, 19, 0.
    ByteBuffer bytes = ByteBuffer.allocate(12 + 8 + 8).order(ByteOrder.LITTLE_ENDIAN).position(12);
    bytes.putInt(5).putInt(1);
    Nibbles nibbles = new Nibbles();
    for (int number : new int[]{2, 3, 2000, 19, 0}) {
      nibbles.add(number);
    }
    nibbles.words().forEach(bytes::putInt);
    Picture picture =
        decoded(new CompressedImage(FRAME, "16UC1; compressedDepth rvl", Bytes.of(bytes.array())), Rendering.USUAL);
    assertEquals("0 = no depth", picture.values().at(1, 0));
    assertEquals("1000 = 1.000\u00a0m", picture.values().at(2, 0));
    assertEquals("990 = 0.990\u00a0m", picture.values().at(4, 0));
  }

  @Test
  void rvlThatLiesAboutItsSizeIsRefused() {
    ByteBuffer bytes = ByteBuffer.allocate(24).order(ByteOrder.LITTLE_ENDIAN).position(12);
    bytes.putInt(100_000).putInt(100_000);
    assertTrue(refused(bytes).startsWith("the picture is too large"), refused(bytes));
    bytes.putInt(12, 4000).putInt(16, 4000);
    assertTrue(refused(bytes).endsWith("the data end too early"), refused(bytes));
    bytes.putInt(12, 1).putInt(16, 1).putInt(20, 0x70000000);
    assertTrue(refused(bytes).endsWith("a run of 7 pixels where 1 are left"), refused(bytes));
  }

  @Test
  void depthIsKeptWithAllItsBits() throws IOException {
    Picture sent = decoded(shorts(PixelEncoding.U16C1, 0, 1, 1500, 65535), Rendering.USUAL);
    byte[] file = PicturePng.numbers(sent).orElseThrow();
    Picture again = decoded(new CompressedImage(FRAME, "16UC1; png compressed ", Bytes.of(file)), Rendering.USUAL);
    assertEquals("65535 = 65.535\u00a0m", again.values().at(3, 0));
    assertEquals("1 = 0.001\u00a0m", again.values().at(1, 0));
    Picture metres = decoded(floats(1.2345f, Float.NaN, 70), Rendering.USUAL);
    Picture millis = decoded(
        new CompressedImage(FRAME, "png", Bytes.of(PicturePng.numbers(metres).orElseThrow())), Rendering.USUAL);
    assertEquals("1235 = 1.235\u00a0m", millis.values().at(0, 0));
    assertEquals("0 = no depth", millis.values().at(1, 0));
    assertEquals("0 = no depth", millis.values().at(2, 0));
  }

  @ParameterizedTest
  @EnumSource(ColorMap.class)
  void whatWasNotMeasuredHasAColourOfItsOwn(ColorMap map) {
    for (int shade : map.table(256, false)) {
      int distance = Math.abs((shade >> 16 & 255) - (map.nothing() >> 16 & 255))
          + Math.abs((shade >> 8 & 255) - (map.nothing() >> 8 & 255))
          + Math.abs((shade & 255) - (map.nothing() & 255));
      assertTrue(distance > 40, Integer.toHexString(shade));
    }
    assertEquals(map.rgb(0), map.table(16, true)[15]);
    assertNotEquals(map.rgb(0), map.rgb(1));
  }

  private Span span(float[] depth) {
    return decoded(floats(depth), Rendering.USUAL).legend().orElseThrow().span();
  }

  private static RGB near(RGB shown, int expected) {
    RGB wanted = rgb(expected);
    boolean close = Math.abs(shown.red - wanted.red) < 3 && Math.abs(shown.green - wanted.green) < 3
        && Math.abs(shown.blue - wanted.blue) < 3;
    return close ? wanted : shown;
  }

  private static RGB rgb(int value) {
    return new RGB(value >> 16 & 255, value >> 8 & 255, value & 255);
  }

  private static Rendering fixed(double low, double high) {
    return new Rendering(Optional.empty(), false, Optional.of(new Span(low, high)), true);
  }

  private static RawImage floats(float... values) {
    ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    bytes.asFloatBuffer().put(values);
    return Pictures.raw(PixelEncoding.F32C1, values.length, 1, bytes.array());
  }

  private static RawImage shorts(PixelEncoding encoding, int... values) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int value : values) {
      bytes.putShort((short) value);
    }
    return Pictures.raw(encoding, values.length, 1, bytes.array());
  }

  private static Bytes depthPng(float a, float b, int... values) throws IOException {
    BufferedImage image = new BufferedImage(values.length, 1, BufferedImage.TYPE_USHORT_GRAY);
    for (int x = 0; x < values.length; x++) {
      image.getRaster().setSample(x, 0, 0, values[x]);
    }
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    ImageIO.write(image, "png", png);
    ByteBuffer all = ByteBuffer.allocate(12 + png.size()).order(ByteOrder.LITTLE_ENDIAN);
    all.putInt(0).putFloat(a).putFloat(b).put(png.toByteArray());
    return Bytes.of(all.array());
  }

  private String refused(ByteBuffer bytes) {
    Image image = new CompressedImage(FRAME, "16UC1; compressedDepth rvl", Bytes.of(bytes.array()));
    return assertInstanceOf(Decoding.Undecodable.class, decoder.decode(image, Rendering.USUAL)).reason();
  }

  private Picture decoded(Image image, Rendering rendering) {
    return assertInstanceOf(Decoding.Decoded.class, decoder.decode(image, rendering)).picture();
  }
}

package org.robotui.yarp.image;

import java.util.List;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.bottle.YarpValue;

/**
 * A picture.
 *
 * @param pixels what each consists of, as YARP calls it: {@code mono}, {@code rgb}, {@code bgr}, {@code rgba},
 * {@code bgra}, {@code mo16}, {@code dec} (floats), Bayer patterns and others
 * @param pixelBytes of each pixel
 * @param width in pixels
 * @param height in pixels
 * @param quantum each row is filled up to a multiple of so many bytes; 0 where it is not
 * @param rows all bytes, from the top; not to be changed
 */
public record YarpImage(String pixels, int pixelBytes, int width, int height, int quantum, byte[] rows) {
  private static final String KIND = "mat";
  private static final int PARTS = 4;
  private static final int NUMBERS = 5;
  private static final int WIDTH = 3;
  private static final int HEIGHT = 4;
  private static final int QUANTUM = 8;
  private static final int LARGEST = 1 << 16;
  private static final int WIDEST_PIXEL = 1 << 6;

  /**
   * A picture as YARP's programs make it.
   *
   * @param pixels what each consists of
   * @param pixelBytes of each pixel
   * @param width in pixels
   * @param height in pixels
   * @param packed rows that are not filled up
   * @return with rows of multiples of 8 bytes
   */
  public static YarpImage of(String pixels, int pixelBytes, int width, int height, byte[] packed) {
    int row = pixelBytes * width;
    int step = step(row, QUANTUM);
    byte[] rows = step == row ? packed : new byte[step * height];
    for (int y = 0; y < height && step != row; y++) {
      System.arraycopy(packed, y * row, rows, y * step, row);
    }
    return new YarpImage(pixels, pixelBytes, width, height, QUANTUM, rows);
  }

  private static int step(int row, int quantum) {
    return quantum < 2 ? row : (row + quantum - 1) / quantum * quantum;
  }

  /**
   * How many bytes lie between the beginnings of two rows.
   *
   * @return at least those of a row
   */
  public int step() {
    return step(pixelBytes * width, quantum);
  }

  /**
   * Whether a bottle is a picture.
   *
   * @param bottle any
   * @return by its first word
   */
  public static boolean isImage(Bottle bottle) {
    return bottle.size() == PARTS && bottle.get(0).text().equals(KIND);
  }

  /**
   * Reads a picture.
   *
   * @param bottle as a port says it
   * @return the picture
   * @throws YarpFormatException where it is none, or its bytes are not as many as it says
   */
  public static YarpImage read(Bottle bottle) throws YarpFormatException {
    double[] numbers = bottle.get(2).items().numbers();
    if (!isImage(bottle) || numbers.length != NUMBERS
        || !(bottle.get(PARTS - 1) instanceof YarpValue.Blob blob)) {
      throw new YarpFormatException("this is no picture, which is [mat], its pixels, five numbers and a blob");
    }
    return new YarpImage(bottle.get(1).text(), (int) numbers[0], (int) numbers[WIDTH], (int) numbers[HEIGHT],
        (int) numbers[2], blob.bytes()).checked();
  }

  private YarpImage checked() throws YarpFormatException {
    boolean sane = pixelBytes > 0 && pixelBytes <= WIDEST_PIXEL && width >= 0 && width <= LARGEST && height >= 0
        && height <= LARGEST && quantum >= 0 && quantum <= LARGEST;
    if (!sane || (long) step() * height != rows.length) {
      throw new YarpFormatException("a picture of " + width + " x " + height + " pixels of " + pixelBytes
          + " bytes has " + rows.length + " bytes");
    }
    return this;
  }

  /**
   * Writes a picture.
   *
   * @return as a port says it
   */
  public Bottle toBottle() {
    return new Bottle(List.of(YarpValue.Vocab.of(KIND), YarpValue.Vocab.of(pixels),
        Bottle.of(pixelBytes, rows.length, quantum, width, height), YarpValue.Blob.wrap(rows)), 0);
  }
}

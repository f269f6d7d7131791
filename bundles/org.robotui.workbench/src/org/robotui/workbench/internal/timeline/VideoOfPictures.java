package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.robotui.api.replay.PictureVideo;
import org.robotui.api.replay.RecordingVideos;

/** A video in the size of its first picture. */
final class VideoOfPictures implements PictureTarget {
  private static final int BYTES = 3;

  private final RecordingVideos videos;
  private final Path file;
  private final double rate;
  private Optional<PictureVideo> video = Optional.empty();

  /** Given also how many pictures a second it shows. */
  VideoOfPictures(RecordingVideos videos, Path file, double rate) {
    this.videos = videos;
    this.file = file;
    this.rate = rate;
  }

  @Override
  public void add(ImageData picture) throws IOException {
    if (video.isEmpty()) {
      video = Optional.of(videos.begin(file, picture.width, picture.height, rate));
    }
    video.get().add(bgr(picture), picture.width, picture.height);
  }

  private static byte[] bgr(ImageData picture) {
    byte[] bgr = new byte[picture.width * picture.height * BYTES];
    int[] row = new int[picture.width];
    int at = 0;
    for (int y = 0; y < picture.height; y++) {
      picture.getPixels(0, y, picture.width, row, 0);
      for (int pixel : row) {
        RGB colour = picture.palette.getRGB(pixel);
        bgr[at++] = (byte) colour.blue;
        bgr[at++] = (byte) colour.green;
        bgr[at++] = (byte) colour.red;
      }
    }
    return bgr;
  }

  @Override
  public void finish() throws IOException, InterruptedException {
    if (video.isPresent()) {
      video.get().finish();
    }
  }

  @Override
  public void close() {
    video.ifPresent(PictureVideo::close);
  }
}

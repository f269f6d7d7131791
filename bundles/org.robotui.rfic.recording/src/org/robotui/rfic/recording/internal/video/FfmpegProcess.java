package org.robotui.rfic.recording.internal.video;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;

/** A running ffmpeg that makes a video of pictures. For one thread. */
final class FfmpegProcess implements AutoCloseable {
  private static final String MISSING = "videos are written by ffmpeg, which is not installed or not in the PATH:"
      + " install it (of Debian and Ubuntu: sudo apt install ffmpeg)";
  private static final int LONGEST = 400;

  private final Process process;
  private final OutputStream pictures;
  private final CompletableFuture<String> said;
  private final int width;
  private final int height;

  private FfmpegProcess(Process process, int width, int height) {
    this.process = process;
    this.width = width;
    this.height = height;
    pictures = new BufferedOutputStream(process.getOutputStream());
    said = new CompletableFuture<>();
    Thread.ofVirtual().start(() -> {
      try (var words = process.getInputStream()) {
        said.complete(new String(words.readAllBytes(), StandardCharsets.UTF_8).strip());
      } catch (IOException e) {
        said.complete(String.valueOf(e.getMessage()));
      }
    });
  }

  /** Starts one; sizes that are odd get a line more, as most codecs want even ones. */
  static FfmpegProcess start(Path video, int width, int height, double rate) throws IOException {
    List<String> command = List.of("ffmpeg", "-hide_banner", "-v", "error", "-n", "-f", "rawvideo", "-pix_fmt",
        "bgr24", "-s", width + "x" + height, "-r", String.format(Locale.ROOT, "%.6f", rate), "-i", "pipe:0", "-an",
        "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", video.toAbsolutePath().toString());
    try {
      return new FfmpegProcess(new ProcessBuilder(command).redirectErrorStream(true).start(), width, height);
    } catch (IOException e) {
      throw new IOException(MISSING, e);
    }
  }

  /** Adds a picture, in the size of the video. */
  void add(BufferedImage picture) throws IOException {
    BufferedImage fitting = PictureFrame.sized(picture, width, height);
    try {
      pictures.write(((DataBufferByte) fitting.getRaster().getDataBuffer()).getData());
    } catch (IOException e) {
      throw failed(e);
    }
  }

  /** Ends the video. */
  void finish() throws IOException, InterruptedException {
    try {
      pictures.close();
    } catch (IOException e) {
      throw failed(e);
    }
    if (process.waitFor() != 0) {
      throw failed(new IOException("it ended with " + process.exitValue()));
    }
  }

  private IOException failed(IOException cause) {
    String words = said.join();
    return new IOException("ffmpeg failed: "
        + (words.isEmpty() ? cause.getMessage() : words.substring(0, Math.min(LONGEST, words.length()))), cause);
  }

  @Override
  public void close() {
    process.destroy();
  }
}

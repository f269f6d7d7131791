package org.robotui.api.replay;

import java.io.IOException;
import java.nio.file.Path;

/** Writes videos of cameras of recordings that are open. An OSGi service, safe for all threads. */
public interface RecordingVideos {
  /**
   * Writes the pictures of a camera as a video that takes as long as the recording. Reads all of them, which may take
   * minutes; not for the display thread.
   *
   * @param track which recording
   * @param topic of the camera
   * @param video the file, which must not be there yet; its ending says what kind of video
   * @return how many frames the video has
   * @throws IOException where the recording cannot be read, the video cannot be written, or what writes videos is not
   * installed; with a sentence for users
   * @throws InterruptedException where the thread was interrupted
   * @throws IllegalArgumentException where the recording is not open any more, or the topic is no camera
   */
  long write(TrackId track, String topic, Path video) throws IOException, InterruptedException;

  /**
   * Begins a video of any pictures.
   *
   * @param video the file, which must not be there yet; its ending says what kind of video
   * @param width of its pictures, pixels
   * @param height of its pictures, pixels
   * @param rate pictures a second
   * @return takes the pictures; to be closed
   * @throws IOException where the file is there, or what writes videos is not installed; with a sentence for users
   */
  PictureVideo begin(Path video, int width, int height, double rate) throws IOException;
}

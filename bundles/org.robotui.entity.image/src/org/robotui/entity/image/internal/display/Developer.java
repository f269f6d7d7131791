package org.robotui.entity.image.internal.display;

import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.image.Image;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.PictureDecoder;
import org.robotui.entity.image.Rendering;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.shape.Texture;

/**
 * Decodes pictures in the background, one at a time: of those that come meanwhile the newest. Holds the last texture
 * and at most two pictures as they came. Safe for all threads.
 */
final class Developer {
  /**
   * A picture that was decoded.
   *
   * @param texture its pixels; none where it could not be decoded
   * @param words its size and encoding, or why it could not be decoded
   */
  record Developed(Optional<Texture> texture, String words) {}

  private record Wanted(Envelope<? extends Image> envelope, int most) {}

  private final DisplayContext context;
  private final PictureDecoder decoder = new PictureDecoder();
  private Optional<Wanted> next = Optional.empty();
  private boolean busy;
  private boolean closed;
  private volatile Optional<Developed> newest = Optional.empty();

  Developer(DisplayContext context) {
    this.context = context;
  }

  void take(Envelope<? extends Image> envelope, int most) {
    if (claim(new Wanted(envelope, most))) {
      context.background().execute(this::work);
    }
  }

  Optional<Developed> newest() {
    return newest;
  }

  private synchronized boolean claim(Wanted wanted) {
    next = Optional.of(wanted);
    boolean begins = !busy && !closed;
    busy |= begins;
    return begins;
  }

  private synchronized Optional<Wanted> begin() {
    Optional<Wanted> wanted = closed ? Optional.empty() : next;
    next = Optional.empty();
    busy = wanted.isPresent();
    return wanted;
  }

  private void work() {
    begin().ifPresent(wanted -> {
      publish(develop(wanted));
      context.wake();
      context.background().execute(this::work);
    });
  }

  private synchronized void publish(Developed developed) {
    newest = closed ? Optional.empty() : Optional.of(developed);
  }

  private Developed develop(Wanted wanted) {
    return switch (decoder.decode(wanted.envelope().value(), Rendering.USUAL)) {
      case Decoding.Undecodable no -> new Developed(Optional.empty(), no.reason());
      case Decoding.Decoded yes -> developed(yes.picture(), wanted.most());
    };
  }

  private static Developed developed(Picture picture, int most) {
    return new Developed(Optional.of(Textures.of(picture, most)),
        picture.width() + " x " + picture.height() + " " + picture.encoding());
  }

  synchronized void close() {
    closed = true;
    next = Optional.empty();
    newest = Optional.empty();
  }
}

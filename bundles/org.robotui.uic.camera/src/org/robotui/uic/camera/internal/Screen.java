package org.robotui.uic.camera.internal;

import java.util.Optional;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.Image;
import org.robotui.entity.image.Picture;

/** Holds the newest picture in the form in which the platform paints it. Display thread. */
final class Screen {
  private Optional<Picture> shown = Optional.empty();
  private Optional<Image> image = Optional.empty();

  /** The platform's image of a picture; owned by this. */
  Image image(Device device, Picture picture) {
    if (image.isEmpty() || shown.filter(s -> s == picture).isEmpty()) {
      dispose();
      image = Optional.of(new Image(device, picture.pixels()));
      shown = Optional.of(picture);
    }
    return image.get();
  }

  void dispose() {
    image.ifPresent(Image::dispose);
    image = Optional.empty();
  }
}

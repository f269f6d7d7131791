package org.robotui.entity.image.internal.display;

import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.image.Image;
import org.robotui.entity.image.internal.display.Developer.Developed;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;

/** The newest picture, where its camera is now. */
final class ImageDisplay implements Display {
  private final Recent<Image, Boolean> recent = new Recent<>(Image.class, Anchor.When.NOW, Image::frame, image -> 1);
  private final Developer developer;
  private Sheet sheet = new Sheet(0, 0, 0, 0, 0);
  private Optional<TriangleMesh> mesh = Optional.empty();

  ImageDisplay(DisplayContext context) {
    developer = new Developer(context);
  }

  @Override
  public DisplayResult update(DisplayTick tick) {
    int most = Math.toIntExact(tick.settings().integer(PictureSettings.PIXELS));
    tick.newest(Image.class).ifPresent(envelope -> developer.take(envelope, most));
    recent.update(tick);
    Optional<Developed> developed = developer.newest().filter(d -> recent.newest().isPresent());
    if (developed.isEmpty()) {
      return DisplayResult.nothing(recent.status(tick, new DisplayStatus.NoData("the first picture is being decoded")));
    }
    if (developed.get().texture().isEmpty()) {
      return DisplayResult.nothing(recent.status(tick, new DisplayStatus.Unfit(developed.get().words())));
    }
    Texture texture = developed.get().texture().get();
    List<Part> parts = recent.newest().flatMap(entry -> entry.anchor().found())
        .map(at -> List.of(new Part("picture", surface(texture, tick.settings()), at,
            Material.picture(texture, tick.settings().number(PictureSettings.OPACITY) * Recent.opacity(tick)),
            Describer.of(developed.get().words()))))
        .orElse(List.of());
    return new DisplayResult(parts, recent.status(tick, new DisplayStatus.Shown(developed.get().words())),
        recent.dropped());
  }

  private TriangleMesh surface(Texture texture, Settings settings) {
    double width = settings.number(ImageType.WIDTH);
    double height = width * texture.height() / texture.width();
    Sheet next = new Sheet(-width / 2, -height / 2, width / 2, height / 2, settings.number(ImageType.DISTANCE));
    if (mesh.isEmpty() || !next.equals(sheet)) {
      sheet = next;
      mesh = Optional.of(next.mesh());
    }
    return mesh.get();
  }

  @Override
  public void close() {
    developer.close();
    recent.clear();
  }
}

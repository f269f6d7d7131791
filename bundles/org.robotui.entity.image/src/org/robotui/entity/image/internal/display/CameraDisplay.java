package org.robotui.entity.image.internal.display;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Envelope;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.Image;
import org.robotui.entity.image.internal.display.Developer.Developed;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.Anchor;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Properties.Entry;
import org.robotui.gl.shape.TriangleMesh;

/** The pyramid of a camera with the newest picture of the same frame on its base. */
final class CameraDisplay implements Display {
  private static final float EDGE_PIXELS = 1.5f;

  private final Recent<CameraInfo, Optional<Frustum>> recent =
      new Recent<>(CameraInfo.class, Anchor.When.NOW, CameraInfo::frame, info -> 1);
  private final Developer developer;

  CameraDisplay(DisplayContext context) {
    developer = new Developer(context);
  }

  /** What is drawn of a calibration: none where it has none. */
  private record Frustum(TriangleMesh base, LineSet edges) {
    static Optional<Frustum> of(CameraInfo info, double distance) {
      double fx = info.intrinsics().get(0);
      double fy = info.intrinsics().get(4);
      double cx = info.intrinsics().get(2);
      double cy = info.intrinsics().get(5);
      Sheet sheet = new Sheet(-cx / fx * distance, -cy / fy * distance, (info.width() - cx) / fx * distance,
          (info.height() - cy) / fy * distance, distance);
      return fx > 0 && fy > 0 && sheet.possible()
          ? Optional.of(new Frustum(sheet.mesh(), LineSet.of(LineSet.Kind.SEGMENTS, EDGE_PIXELS, sheet.pyramid())))
          : Optional.empty();
    }
  }

  @Override
  public DisplayResult update(DisplayTick tick) {
    recent.update(tick);
    Optional<Recent.Entry<CameraInfo, Optional<Frustum>>> newest = recent.newest();
    if (newest.isEmpty()) {
      return DisplayResult.nothing(recent.status(tick, new DisplayStatus.Shown("")));
    }
    CameraInfo info = newest.get().value();
    pictures(tick, info);
    double distance = tick.settings().number(CameraType.DISTANCE);
    Optional<Frustum> frustum = newest.get().prepared(distance, i -> Frustum.of(i, distance));
    if (frustum.isEmpty()) {
      return DisplayResult.nothing(recent.status(tick,
          new DisplayStatus.Unfit("the camera is not calibrated: its intrinsics give no angle of view")));
    }
    List<Part> parts = newest.get().anchor().found().map(at -> parts(frustum.get(), info, at, tick)).orElse(List.of());
    return new DisplayResult(parts, recent.status(tick, status()), recent.dropped());
  }

  /** Pictures of other cameras, which may come as well, are left out. */
  private void pictures(DisplayTick tick, CameraInfo info) {
    int most = Math.toIntExact(tick.settings().integer(PictureSettings.PIXELS));
    tick.newest(Image.class).filter(envelope -> fits(envelope, info))
        .ifPresent(envelope -> developer.take(envelope, most));
  }

  private static boolean fits(Envelope<Image> envelope, CameraInfo info) {
    return envelope.value().frame().equals(info.frame());
  }

  private DisplayStatus status() {
    return developer.newest()
        .map(d -> d.texture().isPresent() ? new DisplayStatus.Shown(d.words())
            : new DisplayStatus.Partly("no picture: " + d.words()))
        .orElseGet(() -> new DisplayStatus.Partly("no picture of this camera's frame came yet"));
  }

  private List<Part> parts(Frustum frustum, CameraInfo info, RigidTransform at, DisplayTick tick) {
    Settings settings = tick.settings();
    float opacity = Recent.opacity(tick);
    Describer describer = describer(info);
    List<Part> parts = new ArrayList<>();
    parts.add(new Part("edges", frustum.edges(), at,
        Material.flat(ColorSetting.read(settings, CameraType.COLOR).withAlpha(opacity)), describer));
    developer.newest().flatMap(Developed::texture)
        .ifPresent(texture -> parts.add(new Part("picture", frustum.base(), at,
            Material.picture(texture, settings.number(PictureSettings.OPACITY) * opacity), describer)));
    return parts;
  }

  private static Describer describer(CameraInfo info) {
    double fx = info.intrinsics().get(0);
    double fy = info.intrinsics().get(4);
    String view =
        String.format(Locale.ROOT, "%.1f\u00b0 x %.1f\u00b0", angle(info.width(), fx), angle(info.height(), fy));
    return (element, place) -> Properties.of("Camera", new Entry("frame", info.frame().name()),
        new Entry("resolution", info.width() + " x " + info.height()), new Entry("angle of view", view),
        new Entry("focal length", String.format(Locale.ROOT, "%.1f, %.1f px", fx, fy)),
        new Entry("distortion", info.distortionModel().isEmpty() ? "unknown" : info.distortionModel()));
  }

  private static double angle(int pixels, double focal) {
    return Math.toDegrees(2 * Math.atan2(pixels / 2.0, focal));
  }

  @Override
  public void close() {
    developer.close();
    recent.clear();
  }
}

package org.robotui.uic.camera.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Arity;
import org.robotui.api.port.StreamPort;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.Image;

/** Shows what a camera sees. */
@Component(service = UicType.class)
public final class CameraType implements UicType {
  static final StreamPort<Image> IMAGE =
      new StreamPort<>("image", Image.class, Arity.ONE, "the pictures, raw or compressed");
  static final StreamPort<CameraInfo> CAMERA_INFO = new StreamPort<>(
      "camera_info", CameraInfo.class, Arity.OPTIONAL, "the calibration, to tell in which direction a pixel lies");

  private static final double RATE_HZ = 30;

  private static final Descriptor DESCRIPTOR = new Descriptor("camera", "Camera",
      "Shows the pictures of a camera, depth in colours, with zoom, pixel values and a way to keep one.",
      CameraOptions.schema(), List.of(IMAGE, CAMERA_INFO));

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new CameraUic(context);
  }
}

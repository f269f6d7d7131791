package org.robotui.uic.camera.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;
import org.robotui.data.CameraInfo;
import org.robotui.data.Image;

/** Shows what a camera sees. */
@Component(service = UicType.class)
public final class CameraType implements UicType {
  static final String SMOOTH = "smooth";

  static final StreamPort<Image> IMAGE = new StreamPort<>("image", Image.class, Arity.ONE, "the pictures, raw or compressed");
  static final StreamPort<CameraInfo> CAMERA_INFO = new StreamPort<>(
      "camera_info", CameraInfo.class, Arity.OPTIONAL, "the calibration, to tell in which direction a pixel lies");

  private static final double RATE_HZ = 30;

  private static final Schema SCHEMA = Schema.of(Setting.of(SMOOTH, new ValueType.Flag(), true,
      "Whether pixels are smoothed when the picture is scaled; close up they are always shown as they are."));

  @Override
  public String id() {
    return "camera";
  }

  @Override
  public String label() {
    return "Camera";
  }

  @Override
  public String help() {
    return "Shows the pictures of a camera, with zoom, pixel values and a way to keep one.";
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public List<Port> ports() {
    return List.of(IMAGE, CAMERA_INFO);
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

package org.robotui.entity.image.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.Image;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows what a camera sees, where it sees it. */
@Component(service = DisplayType.class)
public final class CameraType implements DisplayType {
  static final String DISTANCE = "distance";
  static final String COLOR = "color";

  static final Schema SCHEMA = Schema.of(
      Setting.of(DISTANCE, new ValueType.Num(0.001, 1000, "m"), 1.0, "How far before the camera the picture stands."),
      ColorSetting.of(COLOR, "#4c9aff", "Colour of the edges."),
      PictureSettings.opacity(0.85), PictureSettings.pixels());

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
    return "Shows the pyramid that a calibrated camera sees, and its picture on the base of it.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(CameraInfo.class, Image.class);
  }

  @Override
  public boolean automatic() {
    return false;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new CameraDisplay(context);
  }
}

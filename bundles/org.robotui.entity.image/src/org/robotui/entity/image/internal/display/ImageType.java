package org.robotui.entity.image.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.image.Image;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows a picture that stands in space. */
@Component(service = DisplayType.class)
public final class ImageType implements DisplayType {
  static final String WIDTH = "width";
  static final String DISTANCE = "distance";

  static final Schema SCHEMA = Schema.of(
      Setting.of(WIDTH, new ValueType.Num(0.001, 1000, "m"), 1.0, "How wide the picture is; its height follows."),
      Setting.of(DISTANCE, new ValueType.Num(-1000, 1000, "m"), 1.0,
          "How far before its frame it stands, along the axis of sight (z)."),
      PictureSettings.opacity(1), PictureSettings.pixels());

  @Override
  public String id() {
    return "image";
  }

  @Override
  public String label() {
    return "Picture";
  }

  @Override
  public String help() {
    return "Shows a picture that stands in space, before the optical frame of its camera.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Image.class);
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
    return new ImageDisplay(context);
  }
}

package org.robotui.ui.show;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.dnd.ByteArrayTransfer;
import org.eclipse.swt.dnd.TransferData;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Subject;

/** How dragged ports travel between the windows of a workbench. Display thread. */
final class PortTransfer extends ByteArrayTransfer {
  private static final String NAME = "application/x-robotui-ports";
  private static final int ID = registerType(NAME);
  private static final int MOST = 1000;

  @Override
  protected int[] getTypeIds() {
    return new int[]{ID};
  }

  @Override
  protected String[] getTypeNames() {
    return new String[]{NAME};
  }

  @Override
  protected void javaToNative(Object object, TransferData transferData) {
    if (object instanceof DraggedPorts ports) {
      super.javaToNative(bytes(ports), transferData);
    }
  }

  @Override
  protected Object nativeToJava(TransferData transferData) {
    return super.nativeToJava(transferData) instanceof byte[] bytes ? ports(bytes).orElse(null) : null;
  }

  static byte[] bytes(DraggedPorts ports) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeUTF(ports.ruic());
      out.writeInt(Math.min(MOST, ports.streams().size()));
      for (Subject.Stream stream : ports.streams().stream().limit(MOST).toList()) {
        write(out, stream);
      }
    } catch (IOException e) {
      throw new IllegalArgumentException("a name is too long to be dragged", e);
    }
    return bytes.toByteArray();
  }

  private static void write(DataOutputStream out, Subject.Stream stream) throws IOException {
    out.writeUTF(stream.port().component());
    out.writeUTF(stream.port().port());
    out.writeInt(Math.min(MOST, stream.fields().size()));
    for (String field : stream.fields().stream().limit(MOST).toList()) {
      out.writeUTF(field);
    }
  }

  /** Any program may offer something under our name: what cannot be read is nothing. */
  static Optional<DraggedPorts> ports(byte[] bytes) {
    try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes))) {
      String ruic = in.readUTF();
      List<Subject.Stream> streams = new ArrayList<>();
      int count = count(in);
      for (int i = 0; i < count; i++) {
        streams.add(read(in));
      }
      return Optional.of(new DraggedPorts(ruic, streams));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private static Subject.Stream read(DataInputStream in) throws IOException {
    SourceId port = new SourceId(in.readUTF(), in.readUTF());
    List<String> fields = new ArrayList<>();
    int count = count(in);
    for (int i = 0; i < count; i++) {
      fields.add(in.readUTF());
    }
    return new Subject.Stream(port, fields);
  }

  private static int count(DataInputStream in) throws IOException {
    int count = in.readInt();
    if (count < 0 || count > MOST) {
      throw new IOException(count + " are not dragged at once");
    }
    return count;
  }
}

package org.robotui.ros.bag;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import org.robotui.ros.message.MessageInfo;

/** Reads bags of format 2.0 whose chunks are not compressed, in the order of the file. */
final class BagReader {

    /** One recorded message: topic, type as announced, time of recording, bytes. */
    record Recorded(String topic, MessageInfo info, long nanos, ByteBuffer bytes) {
    }

    private static final String MAGIC = "#ROSBAG V2.0\n";
    private static final int MESSAGE = 2;
    private static final int CHUNK = 5;
    private static final int CONNECTION = 7;

    private final Map<Integer, Recorded> connections = new HashMap<>();
    private final List<Recorded> messages = new ArrayList<>();

    private BagReader() {
    }

    static List<Recorded> read(Path bag) {
        try {
            ByteBuffer in = ByteBuffer.wrap(Files.readAllBytes(bag));
            String magic = text(in, MAGIC.length());
            if (!magic.equals(MAGIC)) {
                throw new IOException(bag + " is no bag of format 2.0");
            }
            BagReader reader = new BagReader();
            reader.records(in);
            return reader.messages;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void records(ByteBuffer in) throws IOException {
        while (in.hasRemaining()) {
            Map<String, ByteBuffer> header = header(block(in));
            ByteBuffer data = block(in);
            switch (header.get("op").get()) {
                case CHUNK -> chunk(header, data);
                case CONNECTION -> connection(header, data);
                case MESSAGE -> message(header, data);
                default -> {
                }
            }
        }
    }

    private void chunk(Map<String, ByteBuffer> header, ByteBuffer data) throws IOException {
        ByteBuffer compression = header.get("compression");
        String name = text(compression, compression.remaining());
        if (!name.equals("none")) {
            throw new IOException("a chunk is compressed: " + name);
        }
        records(data);
    }

    private void connection(Map<String, ByteBuffer> header, ByteBuffer data) {
        Map<String, ByteBuffer> fields = header(data);
        MessageInfo info = new MessageInfo(
                text(fields.get("type")), text(fields.get("md5sum")), text(fields.get("message_definition")));
        connections.put(header.get("conn").getInt(), new Recorded(text(header.get("topic")), info, 0, data));
    }

    private void message(Map<String, ByteBuffer> header, ByteBuffer data) {
        Recorded connection = connections.get(header.get("conn").getInt());
        ByteBuffer time = header.get("time");
        long nanos = Integer.toUnsignedLong(time.getInt()) * 1_000_000_000L + time.getInt();
        messages.add(new Recorded(connection.topic(), connection.info(), nanos, data));
    }

    private static Map<String, ByteBuffer> header(ByteBuffer in) {
        Map<String, ByteBuffer> fields = new HashMap<>();
        while (in.hasRemaining()) {
            ByteBuffer field = block(in);
            int start = field.position();
            while (field.get() != '=') {
                // up to the equals sign is the name
            }
            ByteBuffer name = field.duplicate().position(start).limit(field.position() - 1);
            fields.put(text(name), field.slice().order(ByteOrder.LITTLE_ENDIAN));
        }
        return fields;
    }

    private static ByteBuffer block(ByteBuffer in) {
        int length = in.order(ByteOrder.LITTLE_ENDIAN).getInt();
        ByteBuffer block = in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN);
        in.position(in.position() + length);
        return block;
    }

    private static String text(ByteBuffer in) {
        return StandardCharsets.UTF_8.decode(in.duplicate()).toString();
    }

    private static String text(ByteBuffer in, int length) {
        byte[] bytes = new byte[length];
        in.get(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }
}

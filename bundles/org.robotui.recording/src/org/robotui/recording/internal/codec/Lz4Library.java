package org.robotui.recording.internal.codec;

import net.jpountz.lz4.LZ4Compressor;
import net.jpountz.lz4.LZ4Factory;
import net.jpountz.lz4.LZ4SafeDecompressor;
import net.jpountz.xxhash.XXHash32;
import net.jpountz.xxhash.XXHashFactory;

/**
 * LZ4 for Java by native code where that can be loaded, else in plain Java. What the library itself takes for the
 * fastest way uses methods that new virtual machines warn of.
 */
record Lz4Library(LZ4Compressor compressor, LZ4SafeDecompressor decompressor, XXHash32 sums) {

  static Lz4Library load() {
    try {
      return of(LZ4Factory.nativeInstance(), XXHashFactory.nativeInstance());
    } catch (LinkageError | RuntimeException e) {
      return of(LZ4Factory.safeInstance(), XXHashFactory.safeInstance());
    }
  }

  private static Lz4Library of(LZ4Factory lz4, XXHashFactory sums) {
    return new Lz4Library(lz4.fastCompressor(), lz4.safeDecompressor(), sums.hash32());
  }
}

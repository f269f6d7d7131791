#include "exceptions.h"

namespace robotui::rt::jni {

void throwIoException(JNIEnv* env, const char* sentence) {
  if (env->ExceptionCheck() == JNI_FALSE) {
    if (const jclass type = env->FindClass("java/io/IOException"); type != nullptr) {
      env->ThrowNew(type, sentence);
    }
  }
}

}  // namespace robotui::rt::jni

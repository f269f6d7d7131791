// The native methods of org.robotui.xbot.internal.NativeLink, which says what they do. Handles are addresses of what is
// made here; that none is used after its end, or by two threads at once, is the business of the Java side.
#include <jni.h>

#include <string>

#include "exceptions.h"
#include "robotui/rt/link/client.h"

namespace {

using robotui::rt::jni::guarded;
using robotui::rt::jni::throwIoException;
using robotui::rt::link::Attachment;
using robotui::rt::link::Client;
using robotui::rt::link::JointCommand;
using robotui::rt::link::Reply;

template <class T>
T& object(jlong handle) {
  return *reinterpret_cast<T*>(handle);
}

template <class T>
jlong handle(T* made) {
  return reinterpret_cast<jlong>(made);
}

// Text crosses as UTF-8 bytes: JNI's own strings are another encoding.
std::string text(JNIEnv* env, jbyteArray bytes) {
  std::string result(static_cast<std::size_t>(env->GetArrayLength(bytes)), '\0');
  env->GetByteArrayRegion(bytes, 0, static_cast<jsize>(result.size()), reinterpret_cast<jbyte*>(result.data()));
  return result;
}

jbyteArray bytes(JNIEnv* env, const std::string& text) {
  const auto size = static_cast<jsize>(text.size());
  const jbyteArray result = env->NewByteArray(size);
  if (result != nullptr) {
    env->SetByteArrayRegion(result, 0, size, reinterpret_cast<const jbyte*>(text.data()));
  }
  return result;
}

Client::Milliseconds milliseconds(jint value) { return Client::Milliseconds(value); }

// Java knows no read-only memory but by the buffer: it makes one of this.
template <class T>
jobject view(JNIEnv* env, const T* segment) {
  return env->NewDirectByteBuffer(const_cast<T*>(segment), sizeof(T));
}

}  // namespace

extern "C" {

JNIEXPORT jlong JNICALL Java_org_robotui_xbot_internal_NativeLink_connect(JNIEnv* env, jclass, jbyteArray robot,
                                                                          jint timeout) {
  return guarded(env, [&] { return handle(new Client(text(env, robot), milliseconds(timeout))); });
}

JNIEXPORT jboolean JNICALL Java_org_robotui_xbot_internal_NativeLink_reconnect(JNIEnv* env, jclass, jlong client,
                                                                               jint timeout) {
  return guarded(env, [&] { return static_cast<jboolean>(object<Client>(client).reconnect(milliseconds(timeout))); });
}

JNIEXPORT jlong JNICALL Java_org_robotui_xbot_internal_NativeLink_attach(JNIEnv* env, jclass, jlong client,
                                                                         jint timeout) {
  return guarded(env, [&] { return handle(new Attachment(object<Client>(client).attach(milliseconds(timeout)))); });
}

JNIEXPORT jint JNICALL Java_org_robotui_xbot_internal_NativeLink_hosts(JNIEnv*, jclass, jlong attachment) {
  return static_cast<jint>(object<Attachment>(attachment).hosts.size());
}

JNIEXPORT jobject JNICALL Java_org_robotui_xbot_internal_NativeLink_state(JNIEnv* env, jclass, jlong attachment) {
  return view(env, object<Attachment>(attachment).state.get());
}

JNIEXPORT jobject JNICALL Java_org_robotui_xbot_internal_NativeLink_board(JNIEnv* env, jclass, jlong attachment) {
  return view(env, object<Attachment>(attachment).board.get());
}

JNIEXPORT jobject JNICALL Java_org_robotui_xbot_internal_NativeLink_host(JNIEnv* env, jclass, jlong attachment,
                                                                         jint index) {
  return guarded(
      env, [&] { return view(env, object<Attachment>(attachment).hosts.at(static_cast<std::size_t>(index)).get()); });
}

JNIEXPORT void JNICALL Java_org_robotui_xbot_internal_NativeLink_detach(JNIEnv*, jclass, jlong attachment) {
  delete &object<Attachment>(attachment);
}

JNIEXPORT jbyteArray JNICALL Java_org_robotui_xbot_internal_NativeLink_request(JNIEnv* env, jclass, jlong client,
                                                                               jbyteArray words, jint timeout) {
  return guarded(env, [&] {
    const Reply reply = object<Client>(client).request(text(env, words), milliseconds(timeout));
    return bytes(env, (reply.ok ? "ok " : "error ") + reply.text);
  });
}

JNIEXPORT jboolean JNICALL Java_org_robotui_xbot_internal_NativeLink_reference(JNIEnv* env, jclass, jlong client,
                                                                               jobject commands, jint joints) {
  return guarded(env, [&] {
    const auto* first = static_cast<const JointCommand*>(env->GetDirectBufferAddress(commands));
    const jlong room = env->GetDirectBufferCapacity(commands) / static_cast<jlong>(sizeof(JointCommand));
    if (first == nullptr || joints < 0 || joints > room) {
      throwIoException(env, "references need a direct buffer that holds them");
      return jboolean{JNI_FALSE};
    }
    return static_cast<jboolean>(object<Client>(client).reference({first, static_cast<std::size_t>(joints)}));
  });
}

JNIEXPORT jint JNICALL Java_org_robotui_xbot_internal_NativeLink_notice(JNIEnv* env, jclass, jlong client,
                                                                        jint timeout) {
  return guarded(env, [&] { return static_cast<jint>(object<Client>(client).notice(milliseconds(timeout))); });
}

JNIEXPORT void JNICALL Java_org_robotui_xbot_internal_NativeLink_close(JNIEnv*, jclass, jlong client) {
  delete &object<Client>(client);
}

}  // extern "C"

// The thread that draws frames, and what it shares with those who ask.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/caught.h"
#include "base/stopwatch.h"
#include "renderer/frame/renderer.h"
#include "renderer/image/png.h"
#include "server/frames/frame_job.h"
#include "server/frames/frame_planner.h"
#include "server/frames/frame_queue.h"
#include "server/frames/frame_service.h"
#include "server/frames/renderer_memory.h"
#include "server/frames/shown_fur.h"
#include "server/frames/shown_scene.h"

namespace pelage {

/// A task that tracing runs on the render thread; the renderer is null if that thread is stopping.
using RenderTask = std::function<void(Renderer*)>;

struct FrameService::Impl {
  Impl(ContextSource source, YieldGate& yield_gate, std::size_t coat_memory, int asked_threads);

  const ContextSource contexts;
  std::unique_ptr<Context> context;  // of the render thread; null where there is no GL
  YieldGate& gate;
  std::mutex mutex;
  std::condition_variable wake;
  CoatBaker baker;
  ShortestFirst<std::unique_ptr<FrameJob>> jobs;
  std::deque<RenderTask> tasks;  // after all jobs
  std::vector<std::uint64_t> forgotten;
  bool stopping = false;
  std::string description;
  std::atomic<bool> healthy{true}, draws_shells{false};
  std::atomic<std::size_t> drawn{0}, lost_contexts{0};
  std::atomic<double> seconds{0};
  RendererMemory memory;
  PastScenes past_scenes;
  ShownFur shown_fur;  // of the render thread
  FramePlanner planner;
  const int threads;  // that fur is drawn on
  PngEncoder png;     // of whoever asked, not of the render thread
  const Stopwatch running_time;
  std::vector<FrameJob*> running;  // on the render thread; each was let in by the one before it
  std::thread thread;

  void run(std::promise<Status>& started);
  void serve(Renderer& renderer);
  /// Waits for something to do and does it; false at the end.
  bool serve_next(Renderer& renderer);
  void wake_up() {
    const std::lock_guard lock(mutex);
    wake.notify_one();
  }
  /// Returns whether the render thread has anything to do. Needs the lock.
  bool has_work() const;
  /// Returns whether the frame waits for its coat to be baked, which it then asks for.
  bool waits_for_coat(const Renderer& renderer, const FurFrame& frame, FrameJob& job);
  /// Drops the copies of models that are gone; whether there were any. Needs the lock.
  bool forget_gone(Renderer& renderer);
  /// Draws a job that was taken and answers it, or puts it back where its coat is not there yet.
  void finish(Renderer& renderer, ShortestFirst<std::unique_ptr<FrameJob>>::Taken taken);
  Result<DrawnFrame> draw(Renderer& renderer, FrameJob& job);
  /// The picture of what is shown, and what drawing it took. Counts it.
  Result<DrawnFrame> draw_shown(Renderer& renderer, FrameJob& job, Shown shown, const Stopwatch& passed);
  /// Refused (invalid) for shells where there is no GL.
  Status can_draw(const Knobs& knobs) const;
  /// Runs between the pieces of a job: draws the jobs that wait now and are short compared to it. Returns whether the
  /// job continues.
  bool let_in(Renderer& renderer, FrameJob& job);
  /// Replaces a lost GL by another one, or by none if none can be had.
  void renew_gl(Renderer& renderer);
  /// Running frames of the job's scene that show another revision have to begin anew.
  void mark_outdated(const FrameJob& job);
  void count(double milliseconds, const Status& outcome);
  void add(std::unique_ptr<FrameJob> job);
  /// Adds a job and waits for its frame.
  Result<DrawnFrame> ask(FrameJob job);
  /// Runs `work` on the render thread and waits for it.
  template <class T>
  Result<T> run_task(const std::function<Result<T>(Renderer&)>& work);
};

template <class T>
Result<T> FrameService::Impl::run_task(const std::function<Result<T>(Renderer&)>& work) {
  std::promise<Result<T>> promise;
  std::future<Result<T>> answer = promise.get_future();
  {
    const std::lock_guard lock(mutex);
    if (stopping) return server_stopping();
    tasks.push_back([&](Renderer* renderer) {
      promise.set_value(caught([&] { return renderer ? work(*renderer) : Result<T>(server_stopping()); }));
    });
    wake.notify_one();
  }
  return answer.get();
}

}  // namespace pelage

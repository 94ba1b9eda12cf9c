// The render thread, and the state that it shares with callers of FrameService.
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

/// A task for the render thread from tracing. The renderer is null if the thread is stopping.
using RenderTask = std::function<void(Renderer*)>;

struct FrameService::Impl {
  Impl(ContextSource source, YieldGate& yield_gate, std::size_t coat_memory, int asked_threads);

  const ContextSource contexts;
  std::unique_ptr<Context> context;  // used by the render thread only; null without GL
  YieldGate& gate;
  std::mutex mutex;
  std::condition_variable wake;
  CoatBaker baker;
  ShortestFirst<std::unique_ptr<FrameJob>> jobs;
  std::deque<RenderTask> tasks;  // run while no job is ready
  std::vector<std::uint64_t> forgotten;
  bool stopping = false;
  std::string description;
  std::atomic<bool> healthy{true}, draws_shells{false};
  std::atomic<std::size_t> drawn{0}, lost_contexts{0};
  std::atomic<double> seconds{0};
  RendererMemory memory;
  PastScenes past_scenes;
  RendererCopyStates copy_states;  // used by the render thread only
  FramePlanner planner;
  const int threads;  // CPU threads that draw
  PngEncoder png;     // used by callers, not by the render thread
  const Stopwatch running_time;
  std::vector<FrameJob*> running;  // frames being drawn; each is drawn in a pause of the one before it
  std::thread thread;

  void run(std::promise<Status>& started);
  void serve(Renderer& renderer);
  /// Waits for work and does it. Returns false at the end.
  bool serve_next(Renderer& renderer);
  void wake_up() {
    const std::lock_guard lock(mutex);
    wake.notify_one();
  }
  /// Returns whether the render thread has work. The caller must hold the lock.
  bool has_work() const;
  /// Returns whether the frame has to wait for its coat; if so, requests its baking.
  bool waits_for_coat(const Renderer& renderer, const FurFrame& frame, FrameJob& job);
  /// Drops the copies of removed models. Returns whether there were any. The caller must hold the lock.
  bool forget_gone(Renderer& renderer);
  /// Draws a taken job and answers it, or puts it back if its coat is not baked yet.
  void finish(Renderer& renderer, ShortestFirst<std::unique_ptr<FrameJob>>::Taken taken);
  Result<DrawnFrame> draw(Renderer& renderer, FrameJob& job);
  /// Draws the shown scene. Returns the picture with its timings, and updates the counters.
  Result<DrawnFrame> draw_shown(Renderer& renderer, FrameJob& job, ShownScene shown, const Stopwatch& passed);
  /// Refuses (invalid) shells if there is no GL.
  Status can_draw(const Knobs& knobs) const;
  /// Called in the pauses of a job: draws the jobs that wait now and are short compared to it. Returns whether the job
  /// continues.
  bool run_interleaved(Renderer& renderer, FrameJob& job);
  /// Replaces a lost GL by a new one, or by none if none is available.
  void renew_gl(Renderer& renderer);
  /// Marks running frames of the job's scene that show another revision or time; they have to restart.
  void mark_outdated(const FrameJob& job);
  void count(double milliseconds, const Status& outcome);
  void add(std::unique_ptr<FrameJob> job);
  /// Adds a job and waits for its frame.
  Result<DrawnFrame> submit(FrameJob job);
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
